//! Contents of binary files.

/// Bytes of binary files, in the byte order of the file.
pub struct Bytes {
    pub all: Vec<u8>,
    pub is_big: bool,
}

impl Bytes {
    pub fn text(&mut self, text: &str) {
        self.all.extend(text.as_bytes());
    }

    pub fn put(&mut self, little: &[u8]) {
        match self.is_big {
            true => self.all.extend(little.iter().rev()),
            false => self.all.extend(little),
        }
    }

    pub fn ints(&mut self, all: &[i32]) {
        all.iter().for_each(|x| self.put(&x.to_le_bytes()));
    }

    pub fn sizes(&mut self, all: &[u64]) {
        all.iter().for_each(|x| self.put(&x.to_le_bytes()));
    }

    pub fn doubles(&mut self, all: &[f64]) {
        all.iter().for_each(|x| self.put(&x.to_le_bytes()));
    }
}
