//! How a command ends.

use pelletflow_log::{ExportError, FolderError, LiveError, ReadError, ReportError, RunError};
use pelletflow_scene::{LabSheetError, Mistakes, SceneError, StrengthCardError};
use std::io;

/// What the exit code says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Exit {
    /// Done.
    Done = 0,
    /// Bad input.
    BadInput = 2,
    /// The physics failed, or an expectation is not met.
    Failed = 3,
    /// Reading or writing failed.
    InputOutput = 4,
    /// Interrupted.
    Interrupted = 130,
}

impl Exit {
    pub(crate) fn code(self) -> u8 {
        self as u8
    }

    /// Of a file that is to be read and cannot be.
    fn unreadable(source: &io::Error) -> Self {
        match source.kind() {
            // The name is wrong, and not the disk.
            io::ErrorKind::NotFound
            | io::ErrorKind::IsADirectory
            | io::ErrorKind::NotADirectory => Self::BadInput,
            _ => Self::InputOutput,
        }
    }
}

/// A command that could not do its work.
#[derive(Debug)]
pub(crate) enum Failure {
    /// What to say, and the exit code.
    Message { exit: Exit, message: String },
    /// Nobody reads the output any more, as after `| head`.
    ClosedPipe,
}

impl Failure {
    pub(crate) fn new(exit: Exit, message: impl Into<String>) -> Self {
        Self::Message {
            exit,
            message: message.into(),
        }
    }
}

impl From<Mistakes> for Failure {
    fn from(mistakes: Mistakes) -> Self {
        let count = match mistakes.len() {
            1 => String::new(),
            count => format!("\n\n{count} mistakes"),
        };
        Self::new(Exit::BadInput, format!("{mistakes}{count}"))
    }
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        match error {
            SceneError::Invalid(mistakes) => mistakes.into(),
            SceneError::Unreadable { ref source, .. } => {
                Self::new(Exit::unreadable(source), error.to_string())
            }
        }
    }
}

impl From<StrengthCardError> for Failure {
    fn from(error: StrengthCardError) -> Self {
        match error {
            StrengthCardError::Invalid(mistakes) => mistakes.into(),
            StrengthCardError::Unreadable { ref source, .. } => {
                Self::new(Exit::unreadable(source), error.to_string())
            }
        }
    }
}

impl From<LabSheetError> for Failure {
    fn from(error: LabSheetError) -> Self {
        match error {
            LabSheetError::Invalid(mistakes) => mistakes.into(),
            LabSheetError::Unreadable { ref source, .. } => {
                Self::new(Exit::unreadable(source), error.to_string())
            }
        }
    }
}

impl From<ReadError> for Failure {
    fn from(error: ReadError) -> Self {
        let exit = match error {
            ReadError::Io { .. } => Exit::InputOutput,
            _ => Exit::BadInput,
        };
        Self::new(exit, error.to_string())
    }
}

impl From<ReportError> for Failure {
    fn from(error: ReportError) -> Self {
        match error {
            ReportError::Read(error) => error.into(),
            ReportError::Strength(error) => Self::new(Exit::BadInput, error.to_string()),
        }
    }
}

impl From<ExportError> for Failure {
    fn from(error: ExportError) -> Self {
        match error {
            ExportError::Read(error) => error.into(),
            error => Self::new(Exit::InputOutput, error.to_string()),
        }
    }
}

impl From<LiveError> for Failure {
    fn from(error: LiveError) -> Self {
        let exit = match error {
            LiveError::Address { .. } => Exit::BadInput,
            _ => Exit::InputOutput,
        };
        Self::new(exit, error.to_string())
    }
}

impl From<RunError> for Failure {
    fn from(error: RunError) -> Self {
        let exit = match error {
            RunError::Physics { .. } => Exit::Failed,
            RunError::Output { .. } => Exit::InputOutput,
            RunError::Folder(ref error) => match **error {
                FolderError::Locked { .. }
                | FolderError::Unfinished { .. }
                | FolderError::OtherScene { .. }
                | FolderError::OtherVersion { .. } => Exit::BadInput,
                _ => Exit::InputOutput,
            },
        };
        Self::new(exit, error.to_string())
    }
}
