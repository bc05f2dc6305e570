#!/usr/bin/env bash
# Offsets of free-form outlines beside Clipper's round offset, the clearance diagram beside Boost.Polygon, in the same run
if [ -x "$build/tests/bin/offset_queries" ]; then
  "$build/tests/bin/offset_queries" >"$out/offset-queries.txt"
  sed 's/^/    /' "$out/offset-queries.txt"
  worst() { # pattern before the figure, sort order
    grep -oE "$1 +[0-9.]+" "$out/offset-queries.txt" | awk '{ print $NF }' | sort "$2" | head -1
  }
  at_least "one offset beside Clipper's, the least of all outlines" "$(worst 'ms, Clipper:' -n)" 10 times
  at_most "the diagram beside Boost.Polygon's, the most" "$(worst 'ms, Boost.Polygon:' -rn)" 2.5 times
  at_most "areas off by, in tolerances along the outline" "$(worst 'areas apart' -rn)" 2
else
  echo "  skipped: libpolyclipping-dev is not installed"
fi
