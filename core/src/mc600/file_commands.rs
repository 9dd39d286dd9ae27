//! Commands that move programs and files to, from and between the disks ("The BASIC Filesystem").

use super::Mc600;
use super::code::ANY;
use super::disks::FileName;
use super::firmware::ErrorCode;
use super::program::{Program, STORED_LENGTH};

impl Mc600 {
    pub(super) fn directory(&mut self, mask: u16) -> Result<(), ErrorCode> {
        let mask = if mask == ANY {
            Vec::new()
        } else {
            self.vm.string(mask).to_vec()
        };
        let text = self.disks.directory(&mask)?;
        self.on_new_line(&text);
        Ok(())
    }

    pub(super) fn save(&mut self, name: u16) -> Result<(), ErrorCode> {
        let name = match name {
            // Without a name: the one it was last loaded from or saved to (D48).
            ANY => self.file.clone().ok_or(ErrorCode::Syntax)?,
            name => FileName::parse(self.vm.string(name))?,
        };
        let text = self.program.to_text();
        self.charge_bytes(text.len());
        self.disks.write(&name, &text)?;
        self.file = Some(name);
        Ok(())
    }

    pub(super) fn load_file(&mut self, name: u16) -> Result<(), ErrorCode> {
        let name = FileName::parse(self.vm.string(name))?;
        self.load_named(&name)
    }

    fn load_named(&mut self, name: &FileName) -> Result<(), ErrorCode> {
        let program = self.read_program(name)?;
        self.replace_program(program);
        self.file = Some(name.clone());
        Ok(())
    }

    fn read_program(&mut self, name: &FileName) -> Result<Program, ErrorCode> {
        let bytes = self.disks.read(name).ok_or(ErrorCode::FileNotFound)?;
        self.charge_bytes(bytes.len());
        Program::from_text(&bytes, STORED_LENGTH).map_err(|fault| fault.error)
    }

    /// MERGE changes the program, so what runs is over as with LOAD (D230).
    pub(super) fn merge_file(&mut self, name: u16) -> Result<(), ErrorCode> {
        let name = FileName::parse(self.vm.string(name))?;
        let added = self.read_program(&name)?;
        self.program.merge(&added)?;
        self.program_changed();
        self.finish();
        Ok(())
    }

    pub(super) fn copy(&mut self, from: u16, to: u16) -> Result<(), ErrorCode> {
        let from = FileName::parse(self.vm.string(from))?;
        let to = from.copy_to(self.vm.string(to))?;
        let bytes = self.disks.read(&from).ok_or(ErrorCode::FileNotFound)?;
        self.charge_bytes(bytes.len());
        self.disks.write(&to, &bytes)
    }

    pub(super) fn erase(&mut self, mask: u16) -> Result<(), ErrorCode> {
        let mask = self.vm.string(mask).to_vec();
        self.disks.erase(&mask)
    }

    /// FORMAT takes the time of writing the whole disk.
    pub(super) fn format(&mut self, disk: u16) -> Result<(), ErrorCode> {
        let disk = self.vm.string(disk).to_vec();
        let bytes = self.disks.format(&disk)?;
        self.charge_bytes(bytes);
        Ok(())
    }

    /// The application that the drive's ALIAS names is loaded from B: and run (Installation).
    pub(super) fn start_application(&mut self, alias: &str) {
        let name = if alias.contains(':') {
            alias.to_owned()
        } else {
            format!("B:{alias}")
        };
        let started = FileName::parse(name.as_bytes())
            .and_then(|name| self.load_named(&name))
            .and_then(|()| self.start(None));
        if let Err(error) = started {
            self.report(error, None);
            self.finish();
        }
    }
}
