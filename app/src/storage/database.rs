//! The browser's database: the present project, and earlier versions of it.

use std::future::Future;

use idb::builder::{DatabaseBuilder, ObjectStoreBuilder};
use idb::{Query, Transaction, TransactionMode};
use wasm_bindgen::JsValue;

use super::Fault;
use crate::clock;
use crate::state::versions::Version;

/// Of the two stores below. What is in them has a version of its own.
const VERSION: u32 = 1;
/// The text of the project, under one key.
const PRESENT: &str = "present";
const PROJECT: &str = "project";
/// The texts of earlier versions, each under its [`Version`] as text.
const VERSIONS: &str = "versions";
/// A browser whose database is damaged may never answer, ms.
const PATIENCE_MS: u32 = 3000;

/// An open database.
pub(super) struct Database(idb::Database);

/// What is to be written, all or nothing.
#[derive(Default)]
pub(super) struct Changes<'a> {
    /// The text of the present project.
    pub(super) present: Option<&'a str>,
    /// A text to go back to.
    pub(super) version: Option<(Version, &'a str)>,
    /// Versions that go.
    pub(super) dropped: &'a [Version],
}

/// What is kept.
pub(super) struct Contents {
    /// The text of the project.
    pub(super) present: Option<String>,
    /// The versions to go back to.
    pub(super) versions: Vec<Version>,
}

impl Database {
    /// Opens the database of that name, or makes it.
    pub(super) async fn open(name: &str) -> Result<Database, Fault> {
        let builder = DatabaseBuilder::new(name)
            .version(VERSION)
            .add_object_store(ObjectStoreBuilder::new(PRESENT))
            .add_object_store(ObjectStoreBuilder::new(VERSIONS));
        match clock::within(PATIENCE_MS, builder.build()).await {
            Some(Ok(database)) => Ok(Database(database)),
            Some(Err(_)) | None => Err(Fault::Refused),
        }
    }

    /// Reads all but the texts of the versions.
    pub(super) async fn read(&self) -> Result<Contents, Fault> {
        let both = async {
            let transaction = self.transaction(TransactionMode::ReadOnly)?;
            let present = transaction.object_store(PRESENT)?.get(key(PROJECT))?;
            let versions = transaction
                .object_store(VERSIONS)?
                .get_all_keys(None, None)?;
            // Both listen for their answers before either is waited for.
            let (present, versions) = (present.into_future(), versions.into_future());
            Ok::<_, idb::Error>((present.await?, versions.await?))
        };
        let (present, versions) = both.await.map_err(|_| Fault::Refused)?;
        let version = |key: JsValue| serde_json::from_str(&key.as_string()?).ok();
        Ok(Contents {
            present: present.and_then(|text| text.as_string()),
            // What another version of the page has put there is left alone.
            versions: versions.into_iter().filter_map(version).collect(),
        })
    }

    /// The text of an earlier version.
    pub(super) async fn version(&self, version: Version) -> Result<String, Fault> {
        let text = async {
            let transaction = self.transaction(TransactionMode::ReadOnly)?;
            transaction
                .object_store(VERSIONS)?
                .get(version_key(version))?
                .await
        };
        let text = text.await.map_err(|_| Fault::Refused)?;
        text.and_then(|text| text.as_string()).ok_or(Fault::Gone)
    }

    /// Writes. The browser has it when this returns, so that the page may go; what comes of it is told later.
    pub(super) fn write(
        &self,
        changes: &Changes,
    ) -> impl Future<Output = Result<(), Fault>> + use<> {
        let written = self.begin(changes);
        async move {
            let (transaction, seen) = written.map_err(|_| Fault::Closed)?;
            match transaction.await {
                Ok(result) if result.is_committed() => Ok(()),
                _ => Err(match seen.error().map(|error| error.name()) {
                    Some(name) if name == "QuotaExceededError" => Fault::Full,
                    _ => Fault::Refused,
                }),
            }
        }
    }

    /// Gives the transaction twice: one is used up by waiting for it, the other knows why it failed.
    fn begin(&self, changes: &Changes) -> Result<(Transaction, Transaction), idb::Error> {
        let transaction = self.transaction(TransactionMode::ReadWrite)?;
        let (present, versions) = (
            transaction.object_store(PRESENT)?,
            transaction.object_store(VERSIONS)?,
        );
        if let Some(text) = changes.present {
            present.put(&text.into(), Some(&PROJECT.into()))?;
        }
        if let Some((version, text)) = changes.version {
            versions.put(&text.into(), Some(&version_key(version)))?;
        }
        for version in changes.dropped {
            versions.delete(key(version_key(*version)))?;
        }
        // Without this it would wait for the answers to the above, which a page that goes never takes.
        Ok((transaction.commit()?, present.transaction()))
    }

    fn transaction(&self, mode: TransactionMode) -> Result<Transaction, idb::Error> {
        self.0.transaction(&[PRESENT, VERSIONS], mode)
    }
}

impl Drop for Database {
    fn drop(&mut self) {
        self.0.close();
    }
}

fn key(key: impl Into<JsValue>) -> Query {
    Query::Key(key.into())
}

fn version_key(version: Version) -> JsValue {
    serde_json::to_string(&version).unwrap_or_default().into()
}
