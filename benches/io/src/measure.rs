//! Time and memory of one file: written once, read by every library.

use crate::files::File;
use crate::heap;
use crate::shape::{Answer, Shape};
use serde::Serialize;
use std::error::Error;
use std::fs;
use std::hint::black_box;
use std::path::Path;
use std::time::{Duration, Instant};

/// Something that is timed.
type Work<'a> = Box<dyn Fn() -> Result<(), Box<dyn Error>> + 'a>;

/// What one library did with one file.
#[derive(Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) format: &'static str,
    pub(crate) what: String,
    pub(crate) triangles: usize,
    pub(crate) file_bytes: usize,
    pub(crate) median_seconds: f64,
    pub(crate) best_seconds: f64,
    /// The most that was on the heap at once, beyond what was there before.
    pub(crate) peak_bytes: usize,
}

/// Writes the mesh, reads the file in every way that there is, one after the other in each round.
pub(crate) fn file(
    file: &File,
    mesh: &Shape,
    folder: &Path,
    runs: usize,
) -> Result<Vec<Row>, Box<dyn Error>> {
    let path = folder.join(file.file_name);
    let write = || (file.write)(mesh, &path);
    let mut works: Vec<(String, Work<'_>)> = Vec::new();
    let plain = || {
        black_box(fs::read(&path)?);
        Ok(())
    };
    if file.is_ours {
        works.push(("write, onering".into(), Box::new(write)));
    }
    works.push(("read, std::fs::read".into(), Box::new(plain)));
    write()?;
    for reader in file.readers {
        let expected = mesh.answer();
        let read = || {
            let _ = black_box((reader.read)(&path)?);
            Ok(())
        };
        works.push((format!("read, {}", reader.library), Box::new(read)));
        check(reader.library, file.name, expected, (reader.answer)(&path)?)?;
    }
    let mut times = vec![Vec::new(); works.len()];
    let mut peaks = vec![0; works.len()];
    for round in 0..=runs {
        for (i, (_, work)) in works.iter().enumerate() {
            let start = Instant::now();
            let (result, growth) = heap::growth(work);
            result?;
            if round > 0 {
                times[i].push(start.elapsed());
                peaks[i] = growth.peak;
            }
        }
    }
    let file_bytes = fs::metadata(&path)?.len() as usize;
    let rows = works.into_iter().zip(times).zip(peaks).map(|(((what, _), mut times), peak_bytes)| {
        times.sort();
        Row {
            format: file.name,
            what,
            triangles: mesh.faces.len(),
            file_bytes,
            median_seconds: times.get(times.len() / 2).map_or(0.0, Duration::as_secs_f64),
            best_seconds: times.first().map_or(0.0, Duration::as_secs_f64),
            peak_bytes,
        }
    });
    let rows = rows.collect();
    fs::remove_file(&path)?;
    Ok(rows)
}

fn check(library: &str, format: &str, expected: Answer, found: Answer) -> Result<(), Box<dyn Error>> {
    if found == expected {
        return Ok(());
    }
    Err(format!("{library} reads the {format} file as {found:?}, but it holds {expected:?}").into())
}
