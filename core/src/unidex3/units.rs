//! Several units behind one front panel with an axis-pair selector (1-2), as a person finds them wired (D355).

/// What a station is given.
type Given = Vec<(String, String)>;

/// Units that a panel can be switched to: as many as there are keyboard jumpers (2-4).
const MOST: usize = 8;

/// The options of each unit, where `units=2` to `units=8` may stand among those that all have: the units take the
/// keyboard jumpers in turn, their addresses count on from the first, and the last of them ends the daisy chain.
///
/// # Errors
/// One clear line about a number of units, or an address, that there cannot be.
pub fn units(given: &[(String, String)]) -> Result<Vec<Given>, String> {
    let value = |wanted: &str| given.iter().rev().find(|(key, _)| key == wanted);
    let count = match value("units") {
        None => return Ok(vec![given.to_vec()]),
        Some((_, count)) => count.parse().ok(),
    };
    let count = count.filter(|count| (2..=MOST).contains(count));
    let count = count.ok_or("units is a number from 2 to 8")?;
    let first: usize = match value("address") {
        None => 1,
        Some((_, address)) => address.parse().map_err(|_| "address is a number")?,
    };
    let common = |(key, _): &&(String, String)| key != "units" && key != "address";
    let unit = |place: usize| {
        let mut options: Given = given.iter().filter(common).cloned().collect();
        let mut set = |key: &str, value: String| options.push((key.to_owned(), value));
        set("keyboard", (place + 1).to_string());
        set("address", ((first + place) % 31).to_string());
        if place + 1 < count {
            set("last", "no".to_owned());
        }
        options
    };
    Ok((0..count).map(unit).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn given(words: &str) -> Given {
        let words = words
            .split_whitespace()
            .filter_map(|word| word.split_once('='));
        let own = words.map(|(key, value)| (key.to_owned(), value.to_owned()));
        own.collect()
    }

    #[test]
    fn units_are_set_alike_but_for_what_tells_them_apart() {
        assert_eq!(units(&given("oem=out")), Ok(vec![given("oem=out")]));
        let three = units(&given("address=29 units=3 oem=out")).unwrap();
        let expected = [
            "oem=out keyboard=1 address=29 last=no",
            "oem=out keyboard=2 address=30 last=no",
            "oem=out keyboard=3 address=0",
        ];
        assert_eq!(three, expected.map(given));
    }

    #[test]
    fn a_panel_has_two_to_eight_places() {
        for count in ["0", "1", "9", "", "two", "-2"] {
            assert!(units(&given(&format!("units={count}"))).is_err(), "{count}");
        }
        assert!(units(&given("units=2 address=x")).is_err());
    }
}
