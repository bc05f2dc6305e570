#!/usr/bin/env bash
# Screenshots in both themes at three sizes, to be looked at beside the design
for theme in dark light; do
  for form in 1280x720@1 1920x1080@1 1280x800@2; do
    size=${form%@*} scale=${form#*@}
    QT_SCALE_FACTOR=$scale xvfb-run -a -s "-screen 0 2600x1700x24 +extension GLX" timeout 300 \
      "$bin/workbench_pictures" "$out" "$theme" "$size" "$scale" >"$out/pictures.log" 2>&1
    equal "start, propeller, error, palette, section, measure, preferences, manual: $theme $size scale $scale" "$?" 0
  done
done
equal "pictures made" "$(ls "$out"/*-*-*.png 2>/dev/null | wc -l)" 48
echo "      look at them in ${out#"$root"/}"
