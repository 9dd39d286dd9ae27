use super::*;

fn item(name: &str, bytes: &[u8]) -> MemoryItem {
    MemoryItem {
        name: name.to_owned(),
        bytes: bytes.to_vec(),
    }
}

fn project() -> Project {
    Project {
        work: Work {
            name: "Feeder 2".to_owned(),
            text: "10 PRINT \"\u{dc}\"\n20 GOTO 10".to_owned(),
            breakpoints: vec![1],
            line: LineSettings::new(9600),
            speed: Speed::Times(0.5),
            layout: Layout {
                shares: BTreeMap::from([("editor".to_owned(), 400)]),
                folded: vec!["machine".to_owned()],
                shown: Some("terminal".to_owned()),
            },
            terminal: None,
            settings: Default::default(),
            others: Vec::new(),
        },
        device: Device {
            controller: "mc600".to_owned(),
            power: true,
            memory: Memory {
                version: 1,
                items: vec![
                    item("B:CUT.BAS", b"10 REM \xdc\r\n20 END\r\n"),
                    item("PASSWORD", b""),
                ],
            },
        },
    }
}

/// A file of version 1: what users have. It must be read for ever, and is what this version writes.
const VERSION_1: &str = r#"{
  "format": "motionbench project",
  "version": 1,
  "work": {
    "name": "Feeder 2",
    "text": [
      "10 PRINT \"Ü\"\n",
      "20 GOTO 10"
    ],
    "breakpoints": [
      1
    ],
    "line": {
      "baud": 9600,
      "data_bits": 8,
      "parity": "None",
      "stop_bits": 1,
      "flow": "XonXoff"
    },
    "speed": {
      "Times": 0.5
    },
    "layout": {
      "shares": {
        "editor": 400
      },
      "folded": [
        "machine"
      ],
      "shown": "terminal"
    }
  },
  "device": {
    "controller": "mc600",
    "power": true,
    "memory": {
      "version": 1,
      "items": [
        {
          "name": "B:CUT.BAS",
          "text": [
            "10 REM Ü\r\n",
            "20 END\r\n"
          ]
        },
        {
          "name": "PASSWORD",
          "text": []
        }
      ]
    }
  }
}
"#;

#[test]
fn a_file_of_version_1_is_read_and_written() {
    assert_eq!(Project::read(VERSION_1), Ok(project()));
    assert_eq!(project().file(), VERSION_1);
}

#[test]
fn nothing_is_lost_on_the_way_through_a_file_or_the_browser() {
    let mut project = project();
    let every_byte: Vec<u8> = (0..=255).collect();
    project.device.memory.items.push(item("A:RAW", &every_byte));
    assert_eq!(Project::read(&project.file()), Ok(project.clone()));
    let kept = kept(&project.work, &kept_device(&project.device));
    assert_eq!(Project::read(&kept), Ok(project));
}

/// Of version 2, with work for another controller. There is one kind so far, so its name stands for the other's.
#[test]
fn work_with_several_controllers_needs_version_2() {
    let mut project = project();
    project.work.others.push(Desk {
        text: "10 END".to_owned(),
        breakpoints: Vec::new(),
        line: LineSettings::new(1200),
        terminal: None,
        settings: Default::default(),
        device: project.device.clone(),
    });
    let file = project.file();
    assert!(file.contains("\"version\": 2,\n  \"work\""), "{file}");
    let twice = Project::read(&file).unwrap_err().to_string();
    assert_eq!(
        twice,
        "This project cannot be read: it has a controller twice."
    );
    let other = file.replacen("\"mc600\"", "\"abacus\"", 1);
    let unknown = Project::read(&other).unwrap_err().to_string();
    assert_eq!(
        unknown,
        "This project cannot be read: there is no controller abacus."
    );
}

#[test]
fn switches_that_were_set_need_version_3() {
    let mut project = project();
    project.device.controller = "unidex3".to_owned();
    let address = |number: u8| [("address".to_owned(), format!("address={number}"))];
    project.work.settings = address(7).into();
    let file = project.file();
    assert!(file.contains("\"version\": 3,\n  \"work\""), "{file}");
    assert_eq!(Project::read(&file), Ok(project.clone()));
    project.work.settings = address(31).into();
    let refused = Project::read(&project.file()).unwrap_err().to_string();
    assert_eq!(
        refused,
        "This project cannot be read: a unidex3 cannot be set like its switches."
    );
}

#[test]
fn a_text_may_stand_on_one_line() {
    let text = r#"["10 REM \u00dc\r\n", "20 END\r\n"]"#;
    let read = |text: &str| {
        let mut file: serde_json::Value = serde_json::from_str(VERSION_1).unwrap();
        file["device"]["memory"]["items"][0]["text"] = serde_json::from_str(text).unwrap();
        Project::read(&file.to_string()).unwrap()
    };
    assert_eq!(read(text), project());
    assert_eq!(read(r#""10 REM \u00dc\r\n20 END\r\n""#), project());
}

#[test]
fn what_is_wrong_is_said() {
    let changed = |from: &str, to: &str| {
        assert!(VERSION_1.contains(from), "{from}");
        Project::read(&VERSION_1.replace(from, to))
            .unwrap_err()
            .to_string()
    };
    let errors = [
        (
            changed("\"version\": 1,\n  \"work\"", "\"version\": 7,\n  \"work\""),
            "This project was written by a newer Motionbench: it has version 7 of the format, and this page reads versions up to 3.",
        ),
        (
            changed("motionbench project", "shopping list"),
            "This is not a Motionbench project.",
        ),
        (
            changed("\"name\": \"Feeder 2\",", ""),
            "This project cannot be read: missing field `name`",
        ),
        (
            changed("\"controller\"", "\"colour\""),
            "This project cannot be read: unknown field `colour`, expected one of `controller`, `power`, `memory`",
        ),
        (
            changed("10 REM \u{dc}", "10 REM \u{2126}"),
            "This project cannot be read: no device has the character \u{2126}",
        ),
        (
            changed("9600", "1"),
            "This project cannot be read: no serial line can be set like its line.",
        ),
        (
            changed("0.5", "1000"),
            "This project cannot be read: its speed 1000 is not from 0.01 to 100.",
        ),
        (
            changed("B:CUT.BAS", &"N".repeat(101)),
            "This project cannot be read: the name NNNNNNNNNNNNNNNNNNNN... has more than 100 characters.",
        ),
    ];
    for (said, expected) in errors {
        let what = said.split(" at line ").next().unwrap();
        assert_eq!(what, expected);
    }
    let broken = Project::read("{\n  \"format\": \"motionbench project\" \"version\"").unwrap_err();
    assert_eq!(
        broken.to_string(),
        "This project cannot be read: expected `,` or `}` at line 2 column 35."
    );
}

#[test]
fn what_is_no_project_is_refused() {
    for text in [
        "",
        "[]",
        "null",
        "{}",
        "10 PRINT",
        "{\"format\": 3}",
        "\u{0}",
    ] {
        assert!(Project::read(text).is_err(), "{text}");
    }
    let deep = format!(
        "{{\"format\":\"motionbench project\",\"x\":{}",
        "[".repeat(1_000_000)
    );
    assert!(matches!(Project::read(&deep), Err(ProjectError::Broken(_))));
    assert_eq!(
        Project::read(&" ".repeat(LARGEST + 1)),
        Err(ProjectError::TooLarge)
    );
    // Cut anywhere, it is not taken for a shorter project.
    let file = project().file();
    for end in 0..file.trim_end().len() {
        if let Some(start) = file.get(..end) {
            assert!(Project::read(start).is_err(), "cut at {end}");
        }
    }
}

#[test]
fn a_file_gets_a_name_that_every_system_takes() {
    let named = |name: &str| {
        let mut project = project();
        project.work.name = name.to_owned();
        project.file_name()
    };
    assert_eq!(named("Feeder 2"), "Feeder-2.motionbench.json");
    assert_eq!(named("../a/b:c\n"), "a-b-c.motionbench.json");
    assert_eq!(named(" .. "), "project.motionbench.json");
    assert_eq!(named("\u{c4}chse"), "\u{c4}chse.motionbench.json");
}
