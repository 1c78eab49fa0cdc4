//! When two values are the same.

/// Whether two values are the same up to rounding.
pub fn agree(a: &str, b: &str) -> bool {
    let (a, b): (Vec<&str>, Vec<&str>) = (
        a.split_whitespace().collect(),
        b.split_whitespace().collect(),
    );
    let scale = |words: &[&str]| {
        let numbers = words.iter().filter_map(|w| w.parse::<f64>().ok());
        let finite = numbers.filter(|x| x.is_finite());
        finite.fold(1.0, |most: f64, x| most.max(x.abs()))
    };
    let tolerance = 1e-9 * scale(&a).max(scale(&b));
    a.len() == b.len()
        && a.iter().zip(&b).all(|(a, b)| {
            a == b
                || match (a.parse::<f64>(), b.parse::<f64>()) {
                    (Ok(x), Ok(y)) => {
                        x == y
                            || x.is_nan() && y.is_nan()
                            || (x - y).abs() <= tolerance && a.contains(['.', 'e'])
                    }
                    _ => false,
                }
        })
}
