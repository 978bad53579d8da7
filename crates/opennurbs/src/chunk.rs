//! Reads and writes chunks. A chunk is a code, a length, and as many bytes as the length says, all little-endian.
//! Chunks may contain chunks.
//!
//! If a code has the bit [`CHECKED`], the last four bytes of the chunk are the CRC-32 of its own bytes, without the
//! bytes of the chunks inside it. A chunk whose code has the bit [`SHORT`] has a number in place of the length, and no
//! bytes.

use super::Defect;

const CHECKED: u32 = 0x8000;
const SHORT: u32 = 0x8000_0000;
const CHECKSUM_BYTES: usize = 4;

/// Reads values from bytes. The reader notes which bytes belong to inner chunks, so that the checksum can leave them
/// out.
#[derive(Clone, Debug)]
pub(super) struct Reader<'a> {
    rest: &'a [u8],
    /// CRC-32 of this chunk's own bytes before the current run. `None` if the chunk has no checksum.
    checksum: Option<crc32fast::Hasher>,
    /// The current run: the bytes since the last inner chunk. `rest` is the end of this slice.
    run: &'a [u8],
    expected: u32,
}

impl<'a> Reader<'a> {
    /// Returns a reader of bytes without a checksum.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes, checksum: None, run: bytes, expected: 0 }
    }

    /// Reads the next chunk.
    pub(super) fn chunk(&mut self) -> Result<(u32, Self), Defect> {
        self.end_run();
        let code = self.u32()?;
        let length = u64::from_le_bytes(self.array()?);
        if code & SHORT != 0 {
            self.run = self.rest;
            return Ok((code, Self::new(&[])));
        }
        let bytes = self.bytes(usize::try_from(length).map_err(|_| Defect::Truncated)?)?;
        self.run = self.rest;
        if code & CHECKED == 0 {
            return Ok((code, Self::new(bytes)));
        }
        let end = bytes.len().checked_sub(CHECKSUM_BYTES).ok_or(Defect::Truncated)?;
        let (content, checksum) = bytes.split_at(end);
        let expected = checksum.first_chunk().map_or(0, |bytes| u32::from_le_bytes(*bytes));
        Ok((code, Self { rest: content, checksum: Some(crc32fast::Hasher::new()), run: content, expected }))
    }

    /// Reads the next chunk, which must have this code.
    pub(super) fn chunk_of(&mut self, wanted: u32) -> Result<Self, Defect> {
        let (code, chunk) = self.chunk()?;
        if code == wanted { Ok(chunk) } else { Err(Defect::Structure("an unexpected chunk")) }
    }

    /// Checks the checksum after everything in this chunk was read. Bytes of later versions of the format may be left.
    /// They count as this chunk's own bytes.
    pub(super) fn finish(mut self) -> Result<(), Defect> {
        self.rest = &[];
        self.end_run();
        let matches = self.checksum.is_none_or(|checksum| checksum.finalize() == self.expected);
        if matches { Ok(()) } else { Err(Defect::Checksum) }
    }

    /// Adds the bytes since the last inner chunk to the checksum.
    fn end_run(&mut self) {
        if let Some(checksum) = &mut self.checksum {
            checksum.update(&self.run[..self.run.len() - self.rest.len()]);
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.rest.is_empty()
    }

    pub(super) fn bytes(&mut self, count: usize) -> Result<&'a [u8], Defect> {
        let (bytes, rest) = self.rest.split_at_checked(count).ok_or(Defect::Truncated)?;
        self.rest = rest;
        Ok(bytes)
    }

    /// Reads all bytes that are left.
    pub(super) fn rest(&mut self) -> Result<&'a [u8], Defect> {
        self.bytes(self.rest.len())
    }

    /// Reads `count` items of `size` bytes. Nothing is reserved before the bytes are known to be there.
    pub(super) fn items(&mut self, count: usize, size: usize) -> Result<std::slice::ChunksExact<'a, u8>, Defect> {
        let bytes = count.checked_mul(size).ok_or(Defect::Truncated)?;
        Ok(self.bytes(bytes)?.chunks_exact(size))
    }

    pub(super) fn array<const N: usize>(&mut self) -> Result<[u8; N], Defect> {
        let (bytes, rest) = self.rest.split_first_chunk().ok_or(Defect::Truncated)?;
        self.rest = rest;
        Ok(*bytes)
    }

    pub(super) fn u8(&mut self) -> Result<u8, Defect> {
        Ok(self.array::<1>()?[0])
    }

    pub(super) fn u32(&mut self) -> Result<u32, Defect> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    /// Reads the number of items of a list, which is stored as an i32.
    pub(super) fn count(&mut self) -> Result<usize, Defect> {
        let count = i32::from_le_bytes(self.array()?);
        usize::try_from(count).map_err(|_| Defect::Structure("a negative count"))
    }

    pub(super) fn f64(&mut self) -> Result<f64, Defect> {
        Ok(f64::from_le_bytes(self.array()?))
    }

    /// Reads a version, which is one byte, and returns its minor part. Fails if the major part is another one.
    pub(super) fn version(&mut self, class: &str, major: u8) -> Result<u8, Defect> {
        let version = self.u8()?;
        if version >> 4 == major {
            return Ok(version & 15);
        }
        Err(Defect::Unsupported(format!("is a {class} of version {}, and this server reads {major}", version >> 4)))
    }
}

/// Writes values and chunks.
#[derive(Debug, Default)]
pub(super) struct Writer {
    bytes: Vec<u8>,
    checksum: crc32fast::Hasher,
}

impl Writer {
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    pub(super) fn raw(&mut self, bytes: &[u8]) {
        self.checksum.update(bytes);
        self.bytes.extend_from_slice(bytes);
    }

    pub(super) fn u8(&mut self, value: u8) {
        self.raw(&[value]);
    }

    pub(super) fn u32(&mut self, value: u32) {
        self.raw(&value.to_le_bytes());
    }

    pub(super) fn f64(&mut self, value: f64) {
        self.raw(&value.to_le_bytes());
    }

    /// Writes a chunk with the bytes that `content` writes.
    pub(super) fn chunk(&mut self, code: u32, content: impl FnOnce(&mut Self)) {
        let outer = std::mem::take(&mut self.checksum);
        self.bytes.extend_from_slice(&code.to_le_bytes());
        let at = self.bytes.len();
        self.bytes.extend_from_slice(&[0; 8]);
        if code & SHORT == 0 {
            content(self);
        }
        let own = std::mem::replace(&mut self.checksum, outer);
        if code & CHECKED != 0 && code & SHORT == 0 {
            self.bytes.extend_from_slice(&own.finalize().to_le_bytes());
        }
        let length = (self.bytes.len() - at - 8) as u64;
        self.bytes[at..at + 8].copy_from_slice(&length.to_le_bytes());
    }
}
