#!/usr/bin/env bash
# Number 4: numbers that were typed are kept
qtest "named numbers: expressions, tables, parameters, files by hand" "$build/tests/bin/named_numbers_test"
qtest "sides of drawn outlines: rectangles stay rectangles" "$build/tests/bin/outline_sides_test"
qtest "in the window: sides, expressions, names, their table" "$build/tests/bin/typed_numbers_test"
place=$(mktemp -d)
cat >"$place/make.py" <<'P'
import json, sys, zipfile
document = {"blossom": 1, "numbers": [{"name": "w", "value": "20 mm"}, {"name": "half", "value": "w/2"}],
            "features": [{"id": "box", "type": "modeling.box", "name": "Box", "parameters": {"width": "2*w", "depth": "half", "height": 5}, "inputs": []}]}
with zipfile.ZipFile(sys.argv[1], "w") as archive:
    archive.writestr("mimetype", "application/x-blossom")
    archive.writestr("document.json", json.dumps(document))
P
python3 "$place/make.py" "$place/hand.blossom"
equal "a document written by hand with names: volume" "$("$bin/blossom" info "$place/hand.blossom" --json | json volume | xargs printf "%.6f")" 2000.000000
equal "--set w=30mm" "$("$bin/blossom" run "$place/hand.blossom" --set w=30mm -o "$place/wide.blossom" --json >/dev/null; "$bin/blossom" info "$place/wide.blossom" --json | json volume | xargs printf "%.6f")" 4500.000000
equal "--set box.height=2*half keeps the names" "$("$bin/blossom" run "$place/wide.blossom" --set 'box.height=2*half' -o "$place/high.blossom" --json >/dev/null; "$bin/blossom" run "$place/high.blossom" --set w=10mm -o "$place/small.blossom" >/dev/null; "$bin/blossom" info "$place/small.blossom" --json | json volume | xargs printf "%.6f")" 1000.000000
rm -rf "$place"
