//! The controller's disks: what is on them, out to the user and in from there.

use leptos::ev;
use leptos::html;
use leptos::prelude::*;
use leptos::task::spawn_local;
use motionbench_core::controller::DiskInfo;
use motionbench_core::language::latin1;
use web_sys::FileList;

use super::file::read;
use crate::panels::dialog::Dialog;
use crate::protocol::ToWorker;
use crate::state::{Store, words};
use crate::storage::files;

/// Shows the disks.
#[component]
pub(super) fn DisksDialog(store: Store, open: RwSignal<bool>) -> impl IntoView {
    let disks = move || {
        let disks = store.kind().disks.iter();
        disks
            .map(|disk| view! { <Disk store disk /> })
            .collect_view()
    };
    view! {
        <Dialog open=open title="Disks of the controller">
            <div class="dialog-body">
                <p>"Drop text files on a disk, or choose them; they take no time on the line."</p>
                <Filed store />
                {disks}
            </div>
        </Dialog>
    }
}

/// What came of the last file.
#[component]
fn Filed(store: Store) -> impl IntoView {
    view! {
        <div class="said" role="status">
            {move || store.filed.get().map(|filed| match filed {
                Ok(name) => view! { <p>{name}" is on the disk."</p> }.into_any(),
                Err(why) => view! { <p class="wrong">{why}</p> }.into_any(),
            })}
        </div>
    }
}

/// One disk: its files, and where others are dropped.
#[component]
fn Disk(store: Store, disk: &'static DiskInfo) -> impl IntoView {
    let input = NodeRef::<html::Input>::new();
    let over = RwSignal::new(false);
    let listed = Memo::new(move |_| files_of(store, disk));
    let drop = move |event: ev::DragEvent| {
        event.prevent_default();
        over.set(false);
        if let Some(files) = event.data_transfer().and_then(|data| data.files()) {
            put(store, disk, &files);
        }
    };
    let drag = move |event: ev::DragEvent| {
        event.prevent_default();
        over.set(true);
    };
    let choose = move |_| {
        let Some(input) = input.get_untracked() else {
            return;
        };
        if let Some(files) = input.files() {
            put(store, disk, &files);
        }
        // The same file may be chosen again.
        input.set_value("");
    };
    let row = move |(name, bytes): (String, usize)| {
        let whole = format!("{}{name}", disk.prefix);
        let label = format!("Save {whole} as a file");
        let save = move |_| save(store, &whole);
        view! {
            <li>
                <code>{name}</code>
                <span class="figures muted">{words::number(bytes as f64, 0)}" bytes"</span>
                <button type="button" class="button" aria-label=label on:click=save>"Save"</button>
            </li>
        }
    };
    view! {
        <section class="disk" class:over=over aria-label=format!("Disk {}", disk.prefix)
            on:drop=drop on:dragover=drag on:dragleave=move |_| over.set(false)>
            <h3>{disk.prefix}" "<span class="muted">{disk.words}</span></h3>
            <Show when=move || !listed.with(Vec::is_empty) fallback=|| view! { <p class="muted">"No files."</p> }>
                <ul class="versions">{move || listed.get().into_iter().map(row).collect_view()}</ul>
            </Show>
            <label class="labelled">{format!("Files for {}", disk.prefix)}
                <input class="input" type="file" multiple node_ref=input on:change=choose />
            </label>
        </section>
    }
}

/// Names without the disk, and their lengths.
fn files_of(store: Store, disk: &DiskInfo) -> Vec<(String, usize)> {
    store.kept.with(|memory| {
        let items = memory.iter().flat_map(|memory| &memory.items);
        let files = items.filter_map(|item| {
            let name = item.name.strip_prefix(disk.prefix)?;
            Some((name.to_owned(), item.bytes.len()))
        });
        files.collect()
    })
}

/// Gives the user a file of the controller's.
fn save(store: Store, whole: &str) {
    let text = store.kept.with_untracked(|memory| {
        let mut items = memory.iter().flat_map(|memory| &memory.items);
        let item = items.find(|item| item.name == whole)?;
        Some(latin1::text(&item.bytes))
    });
    let name = whole.rsplit(':').next().unwrap_or(whole);
    let saved = text.map(|text| files::save(name, "text/plain", &text));
    if let Some(Err(_)) = saved {
        let why = "The browser refuses to save a file.".to_owned();
        store.filed.set(Some(Err(why)));
    }
}

/// Gives files of the user's to the controller.
fn put(store: Store, disk: &'static DiskInfo, files: &FileList) {
    for index in 0..files.length() {
        let Some(file) = files.get(index) else {
            continue;
        };
        spawn_local(async move {
            match read(&file).await {
                Ok(text) => {
                    let name = format!("{}{}", disk.prefix, file.name().to_ascii_uppercase());
                    store.send(ToWorker::PutFile { name, text });
                    store.send(ToWorker::Keep);
                }
                Err(words) => store.filed.set(Some(Err(words))),
            }
        });
    }
}
