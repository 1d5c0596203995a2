//! Runs LinuxCNC's stand-alone interpreter. In: programs. Out: its result for each.
//!
//! Many programs go into one file. `rs274` stops at the first error; the remaining programs then run again in
//! a new file, so an error ends only one program.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use crate::canon::{self, Run};
use crate::program::Program;
use crate::translate;

/// Programs per file: few enough that running the rest again after an error is cheap.
const BATCH: usize = 25;

/// The interpreter, and a folder for its files.
pub struct Rs274 {
    folder: PathBuf,
}

impl Rs274 {
    /// Finds the interpreter.
    pub fn find() -> Result<Self, String> {
        let there = Command::new("rs274").stdin(Stdio::null()).arg("-h").output().is_ok();
        if !there {
            return Err("LinuxCNC's interpreter `rs274` is not installed; on Debian and its kin:\n\n    \
                        sudo apt-get install linuxcnc-uspace\n"
                .to_owned());
        }
        let folder = env::temp_dir().join(format!("compare-linuxcnc-{}", std::process::id()));
        fs::create_dir_all(&folder)
            .map_err(|error| format!("cannot make the folder {}: {error}", folder.display()))?;
        Ok(Self { folder })
    }

    /// Runs each program separately.
    pub fn run(&self, programs: &[Program]) -> Result<Vec<Run>, String> {
        let texts: Vec<String> =
            programs.iter().enumerate().map(|(name, program)| translate::linuxcnc(program, name)).collect();
        let mut runs = Vec::with_capacity(programs.len());
        while runs.len() < programs.len() {
            let first = runs.len();
            let mut found = self.run_file(&texts[first..texts.len().min(first + BATCH)])?;
            while let Some(run) = found.remove(&runs.len()) {
                runs.push(run);
            }
            if runs.len() == first {
                return Err(format!("`rs274` did not come to program {first}"));
            }
        }
        Ok(runs)
    }

    /// Runs programs in one file up to the first error.
    fn run_file(&self, texts: &[String]) -> Result<BTreeMap<usize, Run>, String> {
        let file = self.folder.join("programs.ngc");
        let text = texts.concat() + "M2\n";
        fs::write(&file, text).map_err(|error| format!("cannot write {}: {error}", file.display()))?;
        let output = Command::new("rs274")
            .arg("-g")
            .arg(&file)
            .current_dir(&self.folder)
            // It keeps its tool table in `HOME`; two simultaneous runs would share it.
            .env("HOME", &self.folder)
            .stdin(Stdio::null())
            .output()
            .map_err(|error| format!("cannot start `rs274`: {error}"))?;
        let mut runs = canon::read(&String::from_utf8_lossy(&output.stdout))?;
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        if let Some((block, message)) = error(&told) {
            let last = runs.last_entry().ok_or_else(|| format!("`rs274` runs no program: {told}"))?;
            last.into_mut().refused = Some((block, message));
        } else if runs.len() < texts.len() {
            return Err(format!("`rs274` stopped ({}) without saying why: {told}", output.status));
        }
        Ok(runs)
    }
}

impl Drop for Rs274 {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(Path::new(&self.folder));
    }
}

/// The block and the message of an error. The message precedes the line, which begins with its N word.
fn error(told: &str) -> Option<(usize, String)> {
    let lines: Vec<&str> = told.lines().collect();
    lines.windows(2).find_map(|pair| {
        let (number, _) = pair[1].strip_prefix('N')?.split_once(' ')?;
        Some((number.parse().ok()?, pair[0].to_owned()))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_names_its_block() {
        let told = "executing\nSpindle not turning in G33\nN30 G90 G33 Z-30. K2.\n";
        assert_eq!(error(told), Some((30, "Spindle not turning in G33".to_owned())));
        assert_eq!(error("executing\n"), None);
    }
}
