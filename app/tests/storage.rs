//! Kept work, in the database of a browser.
#![cfg(target_family = "wasm")]

use std::cell::RefCell;
use std::rc::Rc;

use idb::{Query, TransactionMode};
use js_sys::{Object, Reflect};
use leptos::prelude::*;
use motionbench_app::clock::within;
use motionbench_app::protocol::Speed;
use motionbench_app::state::project::{Device, Layout, Project, ProjectError, Work};
use motionbench_app::state::versions::Reason;
use motionbench_app::storage::{Fault, Keeper, Keeping};
use motionbench_core::controller::{Memory, MemoryItem};
use motionbench_core::serial::LineSettings;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};

wasm_bindgen_test_configure!(run_in_browser);

fn project(text: &str) -> Project {
    Project {
        work: Work {
            name: "Test".to_owned(),
            text: text.to_owned(),
            breakpoints: Vec::new(),
            line: LineSettings::new(9600),
            speed: Speed::Max,
            layout: Layout::default(),
            terminal: None,
            settings: Default::default(),
            others: Vec::new(),
        },
        device: Device {
            controller: "mc600".to_owned(),
            power: true,
            memory: Memory {
                version: 1,
                items: vec![MemoryItem {
                    name: "B:CUT.BAS".to_owned(),
                    bytes: b"10 REM \xdc\r\n".to_vec(),
                }],
            },
        },
    }
}

/// A page with a project that is kept in the database `name`.
struct Page {
    keeper: Keeper,
    project: Rc<RefCell<Project>>,
}

impl Page {
    /// Opens the page; what it has without a kept project is empty.
    async fn open(name: &'static str) -> (Page, Option<Project>) {
        let keeper = Keeper::new(name);
        let found = keeper.open().await;
        let project = Rc::new(RefCell::new(found.clone().unwrap_or_else(|| project(""))));
        let shared = project.clone();
        keeper.watch(
            move || shared.borrow().work.clone(),
            &project.borrow().device,
        );
        (Page { keeper, project }, found)
    }

    fn edit(&self, text: &str) {
        self.project.borrow_mut().work.text = text.to_owned();
        self.keeper.work_changed();
    }

    fn state(&self) -> Keeping {
        self.keeper.state.get_untracked()
    }

    /// Waits for a state; `ms` is more than it may take.
    async fn becomes(&self, ms: u32, wanted: impl Fn(&Keeping) -> bool) {
        let found = within(ms, async {
            while !wanted(&self.state()) {
                rest(10).await;
            }
        });
        assert!(found.await.is_some(), "it stays {:?}", self.state());
    }

    async fn is_kept(&self) {
        self.becomes(1000, |state| matches!(state, Keeping::Kept(_)))
            .await;
    }
}

async fn rest(ms: u32) {
    within(ms, std::future::pending::<()>()).await;
}

/// The text of the project in a database, past the keeper; `put` writes it first.
async fn raw(name: &str, put: Option<&str>) -> Option<String> {
    let stores = ["present", "versions"];
    let builder = stores
        .iter()
        .fold(idb::Database::builder(name).version(1), |builder, store| {
            builder.add_object_store(idb::builder::ObjectStoreBuilder::new(store))
        });
    let database = builder.build().await.unwrap();
    let transaction = database
        .transaction(&["present"], TransactionMode::ReadWrite)
        .unwrap();
    let store = transaction.object_store("present").unwrap();
    if let Some(text) = put {
        store
            .put(&text.into(), Some(&"project".into()))
            .unwrap()
            .await
            .unwrap();
    }
    let found = store
        .get(Query::Key("project".into()))
        .unwrap()
        .await
        .unwrap();
    database.close();
    found.and_then(|text| text.as_string())
}

#[wasm_bindgen_test]
async fn a_change_is_kept_within_a_second_and_comes_back() {
    let (page, found) = Page::open("test-back").await;
    assert_eq!((found, page.state()), (None, Keeping::Unchanged));
    page.edit("10 END\n");
    assert_eq!(page.state(), Keeping::Changed);
    page.is_kept().await;
    page.keeper.close();

    let (page, found) = Page::open("test-back").await;
    assert_eq!(found, Some(project("10 END\n")));
    let mut device = project("").device;
    device.memory.items[0].bytes = b"20 END".to_vec();
    page.keeper.device_changed(&device);
    page.is_kept().await;
    page.keeper.close();

    let (_, found) = Page::open("test-back").await;
    assert_eq!(found.map(|project| project.device), Some(device));
}

#[wasm_bindgen_test]
async fn a_page_that_goes_has_written_before() {
    let (page, _) = Page::open("test-flush").await;
    // The first change is written at once, the next ones are not.
    page.edit("10 EN");
    page.edit("10 END\n");
    page.keeper.close();
    let (_, found) = Page::open("test-flush").await;
    assert_eq!(found, Some(project("10 END\n")));
}

#[wasm_bindgen_test]
async fn a_page_that_goes_without_a_word_has_written_the_change() {
    let (page, _) = Page::open("test-at-once").await;
    page.edit("10 END\n");
    // Nothing runs between the change and this look at the database.
    let kept = raw("test-at-once", None).await;
    assert!(kept.is_some_and(|text| text.contains("10 END")));
}

#[wasm_bindgen_test]
async fn steady_typing_does_not_put_off_the_writing() {
    let (page, _) = Page::open("test-typing").await;
    for count in 0..30 {
        page.edit(&format!("{count}"));
        rest(30).await;
    }
    let kept = raw("test-typing", None).await;
    assert!(kept.is_some(), "nothing was kept in a second of typing");
}

#[wasm_bindgen_test]
async fn a_project_that_is_open_elsewhere_is_read_only() {
    let (first, _) = Page::open("test-tabs").await;
    first.edit("10 END\n");
    first.is_kept().await;
    let (second, found) = Page::open("test-tabs").await;
    assert_eq!(found, Some(project("10 END\n")));
    assert_eq!(second.state(), Keeping::ReadOnly);
    second.edit("20 END\n");
    assert_eq!(
        second.keeper.back_up(Reason::Import).await,
        Err(Fault::Elsewhere)
    );
    second.keeper.flush();
    rest(600).await;
    first.edit("30 END\n");
    first.keeper.close();
    second.becomes(1000, |state| *state == Keeping::Freed).await;
    let (_, found) = Page::open("test-tabs").await;
    assert_eq!(found, Some(project("30 END\n")));
}

#[wasm_bindgen_test]
async fn a_page_goes_on_with_the_project_when_the_tab_that_had_it_is_closed() {
    let (first, _) = Page::open("test-heir").await;
    first.edit("10 END\n");
    first.is_kept().await;
    let (second, _) = Page::open("test-heir").await;
    assert_eq!(second.state(), Keeping::ReadOnly);
    first.keeper.close();
    second.is_kept().await;
    second.edit("20 END\n");
    second.keeper.close();
    let (_, found) = Page::open("test-heir").await;
    assert_eq!(found, Some(project("20 END\n")));
}

#[wasm_bindgen_test]
async fn what_was_kept_before_can_be_gone_back_to() {
    let (page, _) = Page::open("test-versions").await;
    page.edit("10 REM FIRST\n");
    page.is_kept().await;
    page.keeper.close();

    let (page, _) = Page::open("test-versions").await;
    page.edit("10 REM SECOND\n");
    page.is_kept().await;
    assert_eq!(page.keeper.back_up(Reason::Import).await, Ok(()));
    page.edit("10 REM THIRD\n");
    page.is_kept().await;
    page.keeper.close();

    let (page, _) = Page::open("test-versions").await;
    let mut found = Vec::new();
    for version in page.keeper.versions() {
        let text = page.keeper.version(version).await.unwrap();
        found.push((version.reason, Project::read(&text).unwrap().work.text));
    }
    let expected = [
        (Reason::Import, "10 REM SECOND\n"),
        (Reason::Time, "10 REM FIRST\n"),
        (Reason::Time, "10 REM FIRST\n"),
    ];
    assert_eq!(
        found,
        expected.map(|(reason, text)| (reason, text.to_owned()))
    );
}

#[wasm_bindgen_test]
async fn a_project_of_a_newer_page_stays_as_it_is() {
    const NEWER: &str = r#"{"format":"motionbench project","version":9,"wheels":4}"#;
    raw("test-newer", Some(NEWER)).await;
    let (page, found) = Page::open("test-newer").await;
    assert_eq!(found, None);
    let fault = Fault::Unreadable(ProjectError::Newer(9));
    assert_eq!(page.state(), Keeping::Failed(fault));
    page.edit("10 END\n");
    page.keeper.flush();
    rest(600).await;
    assert_eq!(raw("test-newer", None).await.as_deref(), Some(NEWER));

    assert_eq!(page.keeper.start_over().await, Ok(()));
    page.is_kept().await;
    let versions = page.keeper.versions();
    assert_eq!(versions.last().unwrap().reason, Reason::Unreadable);
    let text = page.keeper.version(*versions.last().unwrap()).await;
    assert_eq!(text.as_deref(), Ok(NEWER));
    page.keeper.close();
    let (_, found) = Page::open("test-newer").await;
    assert_eq!(found, Some(project("10 END\n")));
}

#[wasm_bindgen_test]
async fn a_browser_that_refuses_is_asked_again_and_what_it_had_is_not_lost() {
    let (page, _) = Page::open("test-refused").await;
    page.edit("10 REM BEFORE\n");
    page.is_kept().await;
    page.keeper.close();

    let (global, name) = (js_sys::global(), "indexedDB".into());
    let there: Object = Reflect::get_own_property_descriptor(&global, &name)
        .unwrap()
        .unchecked_into();
    let missing = Object::new();
    Reflect::set(&missing, &"configurable".into(), &true.into()).unwrap();
    Reflect::set(&missing, &"value".into(), &JsValue::UNDEFINED).unwrap();
    Reflect::define_property(&global, &name, &missing).unwrap();
    let (page, found) = Page::open("test-refused").await;
    assert_eq!(
        (found, page.state()),
        (None, Keeping::Failed(Fault::Refused))
    );
    page.edit("10 REM AFTER\n");
    rest(600).await;
    assert_eq!(page.state(), Keeping::Failed(Fault::Refused));

    Reflect::define_property(&global, &name, &there).unwrap();
    page.becomes(8000, |state| matches!(state, Keeping::Kept(_)))
        .await;
    let versions = page.keeper.versions();
    let mut texts = Vec::new();
    for version in versions {
        let text = page.keeper.version(version).await.unwrap();
        texts.push(Project::read(&text).unwrap().work.text);
    }
    assert!(texts.contains(&"10 REM BEFORE\n".to_owned()), "{texts:?}");
}
