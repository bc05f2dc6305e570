#!/usr/bin/env bash
# Plugins are equals: a format, a tool and a feature in the worker from outside of the tree
example=$root/tests/example-plugin
for part in features format tool; do
  at_most "lines of the example's $part.cpp" "$(wc -l <"$example/$part.cpp")" 59
done
"$example/check/run" "$build" >"$out/plugins.log" 2>&1
equal "its three parts build against the installed package: exit code" "$?" 0
checked() { grep -c "^ok *$1" "$out/plugins.log"; }
equal "  its format is written" "$(checked 'a gear is written in it')" 1
equal "  and read" "$(checked 'and read$')" 1
equal "  its feature runs in the worker" "$(checked 'the gear is made in the worker')" 1
equal "  and in no other process" "$(checked 'and not without one')" 1
qtest "its tool, its format and its feature in the window" "$build/tests/bin/example_plugin_window_test"

# A module is known by its manifest before it is loaded; every plugin sends features to the worker by the one inWorker.
plugin=$build/tests/installed-plugin
equal "formats that its plugin.json declares" "$(grep -c '"formats": \["hpgl"\]' "$plugin/plugin.json")" 1
BLOSSOM_PLUGIN_PATH=$plugin "$bin/blossom" formats --json >"$out/formats.json"
equal "blossom formats lists it" "$(grep -c '"hpgl"' "$out/formats.json")" 1
equal "definitions of inWorker" "$(git -C "$root" grep -lE '^FeatureType inWorker\(' -- src plugins ui | grep -c '\.cpp$')" 1
equal "plugins that src/app knows by name" "$(grep -rhoE '"(minkowski|modeling|sweep|morphology|pocket|subdivision)[."]' "$root/src/app" | wc -l)" 0
# A format in the tree is one file and a line in the list.
equal "places outside of its own file that name the format dxf" "$(git -C "$root" grep -nE 'dxfFormat|\(dxf\)' -- src ui plugins | grep -vc '^src/exchange/dxf/dxf.cpp')" 1
