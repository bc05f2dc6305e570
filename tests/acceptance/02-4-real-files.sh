#!/usr/bin/env bash
# Real files: every one opens with the number of entities that an independent count gives
if [ -d "$data" ]; then
  opened=0 files=0
  while read -r file; do
    files=$((files + 1))
    if "$bin/blossom" info "$file" --json >"$out/info.json" 2>/dev/null; then opened=$((opened + 1)); else echo "      cannot open ${file#"$data"/}: $(cat "$out/info.json")"; fi
  done < <(find "$data" -type f ! -name '*.md' | sort)
  equal "files that hold geometry and open with \`blossom info\`" "$opened" "$files"
else
  report SKIP "files that hold geometry" "no shared data" ""
fi
for test in text_formats_test cad_formats_test; do qtest "entity counts against independent counts ($test)" "$build/tests/bin/$test" BLOSSOM_SHARED_DATA="$data"; done
qtest "STEP->STEP and IGES->STEP keep faces, names, colours, volume" "$build/tests/bin/step_roundtrip_test" BLOSSOM_SHARED_DATA="$data"
