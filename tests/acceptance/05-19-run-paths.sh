#!/usr/bin/env bash
# 19: no program loads a library from the folder it is started in
equal "built programs and libraries with an unsafe run path" "$("$root/tests/support/run_paths" "$build" | tail -1 | grep -oE '[0-9]+ with')" "0 with"
DESTDIR=$out/installed cmake --install "$build" >"$out/install.log" 2>&1
equal "installed ones" "$("$root/tests/support/run_paths" "$out/installed" | tail -1 | grep -oE '[0-9]+ with')" "0 with"
strange=$out/strange && mkdir -p "$strange" && : >"$strange/libpugixml.so.1"
equal "blossom beside a false libpugixml.so.1" "$(cd "$strange" && "$bin/blossom" --version >/dev/null 2>&1; echo $?)" 0
rm -rf "${out:?}/installed"
