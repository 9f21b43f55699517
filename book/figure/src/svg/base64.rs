//! Base64 (RFC 4648, section 4), to embed pictures into drawings.

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// `bytes` in base64, padded with `=`.
pub(super) fn encode(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let group = (0..3).fold(0_u32, |group, index| {
            group << 8 | u32::from(chunk.get(index).copied().unwrap_or(0))
        });
        for digit in 0..4 {
            let six_bits = (group >> (18 - 6 * digit)) & 0x3f;
            // n bytes fill n + 1 digits of the group.
            let symbol = if digit <= chunk.len() {
                ALPHABET[six_bits as usize]
            } else {
                b'='
            };
            text.push(char::from(symbol));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::encode;

    #[test]
    fn test_vectors_of_rfc_4648_section_10() {
        let expected = [
            "", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy",
        ];
        for (length, expected) in expected.iter().enumerate() {
            assert_eq!(encode(&b"foobar"[..length]), *expected);
        }
    }

    #[test]
    fn high_bits_use_the_whole_alphabet() {
        assert_eq!(encode(&[0xff, 0xff, 0xfe, 0xfb]), "///++w==");
    }
}
