#!/usr/bin/env bash
# A feature type of a third party, with no line of window code
"$root/tests/example-plugin/check/run" "$build" >"$out/example-plugin.log" 2>&1
equal "the example plugin builds against the installed package, exit code" "$?" 0
qtest "the example plugin in menu, palette, panel and manual" "$build/tests/bin/example_plugin_window_test"
BLOSSOM_PLUGIN_PATH=$build/tests/installed-plugin "$bin/blossom" features --json >"$out/features.json" 2>&1
at_least "the example plugin on the command line" "$(grep -c '"example\.' "$out/features.json")" 1 feature
