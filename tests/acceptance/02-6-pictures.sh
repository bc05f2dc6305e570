#!/usr/bin/env bash
# Pictures, to be looked at with a critical eye
env -u DISPLAY "$bin/blossom" render "$root/resources/samples/propeller.json" -o "$out/propeller.png" --size 1600x1000 >"$out/render.log" 2>&1
equal "PNG of the propeller with no display, exit code" "$?" 0
for theme in dark light; do
  with_display timeout 120 "$bin/blossom-workbench" "$root/resources/samples/propeller.json" --theme $theme --size 1440x900 --screenshot "$out/window-$theme.png" --exit >"$out/window.log" 2>&1
  equal "screenshot of the window, $theme theme, exit code" "$?" 0
done
echo "      look at them in ${out#"$root"/}"
