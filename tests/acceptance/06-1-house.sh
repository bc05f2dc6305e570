#!/usr/bin/env bash
# Floors, folders and files of the house
arrows=$root/tests/support/check_arrows
"$arrows" "$root/tests/support/arrows.txt" >"$out/arrows.log" 2>&1
equal "every include goes down, no circle: exit code" "$?" 0
sed 's/^/      /' "$out/arrows.log"

# The check itself: an include upwards, put in by hand, is found with its line.
probe=$(mktemp -d)
cp -r "$root/src" "$root/ui" "$root/plugins" "$probe"
sed -i '1i #include "scene/scene.h"' "$probe/src/core/units.h"
"$arrows" "$root/tests/support/arrows.txt" "$probe" >"$out/arrows-probe.log" 2>&1
equal "an include upwards put in by hand: exit code" "$?" 1
equal "  told with file and line" "$(grep -c '^src/core/units.h:1: src/core does not see src/scene' "$out/arrows-probe.log")" 1
rm -rf "$probe"

sources() { git -C "$root" ls-files src ui plugins | grep -E '\.(h|cpp)$'; }
at_most "most source files in a folder" "$(sources | xargs -n1 dirname | sort | uniq -c | sort -rn | awk 'NR == 1 { print $1 }')" 40
sizes=$(sources | sed "s#^#$root/#" | xargs stat -c %s | sort -n)
share() { awk -v share="$1" '{ size[NR] = $1 } END { i = int(NR * share); print size[i < 1 ? 1 : i] / 1024 }' <<<"$sizes"; }
at_most "median size of a source file" "$(share 0.5)" 2.5 KB
at_most "nine of ten are at most" "$(share 0.9)" 8 KB
at_most "the largest" "$(share 1)" 16 KB
