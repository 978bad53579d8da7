//! ZIP archives (PKWARE APPNOTE 6.3, without its 64-bit extension). They are written from front to back, so that an
//! archive is never in memory as a whole. Entries are not compressed, because they are small or already in a format for
//! transfer.
//!
//! Every date is 1980-01-01, the first date of the format, so that the same entries give the same bytes.

use crate::formats::Error;

const VERSION: u16 = 20;
/// Flag for names in UTF-8.
const FLAGS: u16 = 1 << 11;
const STORED: u16 = 0;
const DATE: u16 = (1 << 5) | 1;

/// An archive that is being written. It collects the directory, which comes last.
#[derive(Debug, Default)]
pub struct Zip {
    directory: Vec<u8>,
    entries: u16,
    /// Number of bytes written so far.
    length: u32,
}

impl Zip {
    /// Returns the header of the next entry. The caller writes the header and then `bytes`. A name must appear only
    /// once.
    ///
    /// # Errors
    /// Returns [`Error::TooLarge`] from 4 GiB or 65,535 entries.
    pub fn entry(&mut self, name: &str, bytes: &[u8]) -> Result<Vec<u8>, Error> {
        self.entry_of(name, bytes.len(), crc32fast::hash(bytes))
    }

    /// Same as [`Zip::entry`], for a content of this length and CRC-32.
    ///
    /// # Errors
    /// Returns the errors of [`Zip::entry`].
    pub fn entry_of(&mut self, name: &str, length: usize, checksum: u32) -> Result<Vec<u8>, Error> {
        let too_large = || Error::TooLarge { format: "ZIP" };
        let size = u32::try_from(length).map_err(|_| too_large())?;
        let name_length = u16::try_from(name.len()).map_err(|_| too_large())?;
        let mut common = Vec::with_capacity(26);
        for word in [VERSION, FLAGS, STORED, 0, DATE] {
            common.extend_from_slice(&word.to_le_bytes());
        }
        for word in [checksum, size, size] {
            common.extend_from_slice(&word.to_le_bytes());
        }
        common.extend_from_slice(&name_length.to_le_bytes());
        // There is no extra field.
        common.extend_from_slice(&0u16.to_le_bytes());

        let mut header = b"PK\x03\x04".to_vec();
        header.extend_from_slice(&common);
        header.extend_from_slice(name.as_bytes());
        let written = u32::try_from(header.len()).ok().and_then(|length| length.checked_add(size));
        let next = written.and_then(|written| self.length.checked_add(written)).ok_or_else(too_large)?;

        self.directory.extend_from_slice(b"PK\x01\x02");
        self.directory.extend_from_slice(&VERSION.to_le_bytes());
        self.directory.extend_from_slice(&common);
        // There is no comment, the disk is the first one, the content is binary, and there are no attributes.
        self.directory.extend_from_slice(&[0; 10]);
        self.directory.extend_from_slice(&self.length.to_le_bytes());
        self.directory.extend_from_slice(name.as_bytes());
        self.entries = self.entries.checked_add(1).ok_or_else(too_large)?;
        self.length = next;
        Ok(header)
    }

    /// Returns the directory, which the caller writes after the last entry.
    ///
    /// # Errors
    /// Returns the errors of [`Zip::entry`].
    pub fn end(self) -> Result<Vec<u8>, Error> {
        let directory_length = u32::try_from(self.directory.len()).map_err(|_| Error::TooLarge { format: "ZIP" })?;
        let mut end = self.directory;
        end.extend_from_slice(b"PK\x05\x06");
        end.extend_from_slice(&[0; 4]);
        for _ in 0..2 {
            end.extend_from_slice(&self.entries.to_le_bytes());
        }
        end.extend_from_slice(&directory_length.to_le_bytes());
        end.extend_from_slice(&self.length.to_le_bytes());
        // There is no comment.
        end.extend_from_slice(&[0; 2]);
        Ok(end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn archive(entries: &[(&str, &[u8])]) -> Vec<u8> {
        let mut zip = Zip::default();
        let mut bytes = Vec::new();
        for (name, content) in entries {
            bytes.extend(zip.entry(name, content).unwrap());
            bytes.extend_from_slice(content);
        }
        bytes.extend(zip.end().unwrap());
        bytes
    }

    #[test]
    fn the_directory_of_an_archive_gives_the_positions_of_its_entries() {
        let bytes = archive(&[("batch.json", b"{}"), ("0000 ü.glb", b"glTF"), ("empty", b"")]);
        let u16_at = |at: usize| u16::from_le_bytes(bytes[at..at + 2].try_into().unwrap()) as usize;
        let u32_at = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        let end = bytes.len() - 22;
        assert_eq!((&bytes[end..end + 4], u16_at(end + 10)), (&b"PK\x05\x06"[..], 3));
        let (mut at, mut found) = (u32_at(end + 16), Vec::new());
        assert_eq!(at + u32_at(end + 12), end);
        while at < end {
            assert_eq!(&bytes[at..at + 4], b"PK\x01\x02");
            let (crc, size, name_length, header) = (u32_at(at + 16), u32_at(at + 24), u16_at(at + 28), u32_at(at + 42));
            let name = std::str::from_utf8(&bytes[at + 46..at + 46 + name_length]).unwrap();
            assert_eq!(&bytes[header..header + 4], b"PK\x03\x04");
            let content = &bytes[header + 30 + name_length..][..size];
            assert_eq!(crc32fast::hash(content) as usize, crc);
            found.push((name, content));
            at += 46 + name_length;
        }
        assert_eq!(found, [("batch.json", &b"{}"[..]), ("0000 ü.glb", b"glTF"), ("empty", b"")]);
    }

    #[test]
    fn an_archive_too_large_for_the_format_is_refused() {
        let mut zip = Zip { length: u32::MAX - 40, ..Zip::default() };
        assert!(zip.entry("name", b"0123456789").is_err());
        let mut zip = Zip { entries: u16::MAX, ..Zip::default() };
        assert!(zip.entry("name", b"").is_err());
    }
}
