//! What several units behind one front panel hold, as the memory of one controller.

use motionbench_core::controller::{Memory, MemoryItem};

/// Of an item of the second unit: `unit 2 ` and its own name. Those of the first have their own names.
fn prefix(unit: usize) -> String {
    format!("unit {} ", unit + 1)
}

/// The memories of the units, from the first, as one.
pub fn join(memories: impl Iterator<Item = Memory>) -> Memory {
    let mut joined = Memory::default();
    for (unit, memory) in memories.enumerate() {
        joined.version = memory.version;
        let named = |item: MemoryItem| MemoryItem {
            name: match unit {
                0 => item.name,
                _ => prefix(unit) + &item.name,
            },
            ..item
        };
        joined.items.extend(memory.items.into_iter().map(named));
    }
    joined
}

/// The part of each unit of what [`join`] gave. The first keeps what belongs to units that are not there, as a controller
/// keeps what it does not know.
pub fn split(joined: &Memory, units: usize) -> Vec<Memory> {
    let empty = Memory {
        version: joined.version,
        items: Vec::new(),
    };
    let mut memories = vec![empty; units.max(1)];
    for item in &joined.items {
        let own = (1..units).find_map(|unit| {
            let name = item.name.strip_prefix(&prefix(unit))?.to_owned();
            let bytes = item.bytes.clone();
            Some((unit, MemoryItem { name, bytes }))
        });
        let (unit, item) = own.unwrap_or_else(|| (0, item.clone()));
        if let Some(memory) = memories.get_mut(unit) {
            memory.items.push(item);
        }
    }
    memories
}

#[cfg(test)]
mod tests {
    use super::*;

    fn memory(names: &[&str]) -> Memory {
        let item = |name: &&str| MemoryItem {
            name: (*name).to_owned(),
            bytes: name.as_bytes().to_vec(),
        };
        Memory {
            version: 7,
            items: names.iter().map(item).collect(),
        }
    }

    #[test]
    fn each_unit_gets_back_what_it_had() {
        let memories = [
            memory(&["a", "b"]),
            memory(&[]),
            memory(&["a", "unit 2 a", "settings"]),
        ];
        let joined = join(memories.iter().cloned());
        assert_eq!(split(&joined, 3), memories);
        let alone = memory(&["a", "b"]);
        assert_eq!(join([alone.clone()].into_iter()), alone);
        assert_eq!(split(&alone, 1), [alone]);
    }

    #[test]
    fn units_that_were_taken_away_lose_nothing() {
        let joined = join([memory(&["a"]), memory(&["b"]), memory(&["c"])].into_iter());
        let fewer = split(&joined, 2);
        let again = join(fewer.into_iter());
        assert_eq!(split(&again, 3)[2].items[0].name, "c");
    }
}
