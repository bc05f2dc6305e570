#!/usr/bin/env bash
# Number 8: results are kept in the cache folder of the user, and a document opens quickly the second time
qtest "results kept and found, damaged ones ignored, the limit" "$build/tests/bin/result_store_test"
cache=$(mktemp -d)
open() { # document: time from the file being read to the final picture, s
  with_display env XDG_CACHE_HOME="$cache" timeout 300 "$bin/blossom-workbench" --print-timings --screenshot "$out/opened.png" \
    --size 1280x720 --exit "$1" 2>&1 | awk '/document read/ { a = $1 } /final picture/ { b = $1 } END { if (b) printf "%.2f\n", (b - a) / 1000 }'
}
for sample in "$root"/resources/samples/*.blossom "$root"/resources/samples/*.json; do
  first=$(open "$sample")
  at_most "second opening of $(basename "$sample"); the first took ${first:-?} s" "$(open "$sample")" 0.5 s
done
at_most "the cache after all samples" "$(du -sm "$cache" | cut -f1)" 1024 MB
rm -rf "$cache"
