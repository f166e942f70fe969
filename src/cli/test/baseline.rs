//! Operations of tests, compared with those of an earlier run.

use super::super::output::{Overwrite, write};
use super::outcome::{Status, TestRow};
use crate::text::number::short;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// The operations of one call of each test, by file and name. The same on every machine.
#[derive(Default, Serialize, Deserialize)]
pub struct OperationBaseline {
    /// Version of the format.
    schema: u32,
    operations: BTreeMap<String, BTreeMap<String, f64>>,
}

impl OperationBaseline {
    /// Reads the file of `--baseline`.
    ///
    /// # Errors
    /// A message with the path.
    pub fn read(path: &Path) -> Result<OperationBaseline, String> {
        let shown = path.display();
        let text = fs::read_to_string(path);
        let text = text.map_err(|e| format!("cannot read the baseline {shown}: {e}"))?;
        serde_json::from_str(&text).map_err(|e| format!("invalid baseline {shown}: {e}"))
    }

    /// The operations of tests that passed.
    pub fn of(rows: &[TestRow]) -> OperationBaseline {
        let mut baseline = OperationBaseline {
            schema: 1,
            ..OperationBaseline::default()
        };
        for row in rows.iter().filter(|row| row.status != Status::Failed) {
            if let Some(operations) = row.operations {
                let file = baseline.operations.entry(row.file.clone()).or_default();
                file.insert(row.name.clone(), operations);
            }
        }
        baseline
    }

    /// Writes the file of `--save-baseline`.
    ///
    /// # Errors
    /// A message with the path.
    pub fn save(&self, path: &Path) -> Result<(), String> {
        let text = serde_json::to_string_pretty(self).map_err(|e| e.to_string())?;
        let written = write(path, format!("{text}\n").as_bytes(), Overwrite::Allowed);
        written.map_err(|e| format!("cannot write {}: {e}", path.display()))
    }

    /// Compares a test: it fails if it needs more operations than the tolerance, in percent, allows.
    pub fn judge(&self, row: &mut TestRow, tolerance: f64) {
        let known = self.operations.get(&row.file);
        let known = known.and_then(|file| file.get(&row.name)).copied();
        let (Some(operations), Some(known)) = (row.operations, known) else {
            return;
        };
        row.baseline = Some(known);
        if row.status == Status::Passed && operations > known * (1.0 + tolerance / 100.0) {
            row.status = Status::Failed;
            let growth = match known > 0.0 {
                true => format!("{:.1} % more", (operations / known - 1.0) * 100.0),
                false => "more".to_string(),
            };
            let (now, before) = (short(operations), short(known));
            row.message = Some(format!(
                "needs {now} operations, {growth} than the {before} of the baseline"
            ));
        }
    }
}
