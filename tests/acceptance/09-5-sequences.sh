#!/usr/bin/env bash
# Sequences are shapes: features frame by frame, and what is written of them
tests=$build/tests/bin
qtest "features take sequences frame by frame" "$tests/frame_by_frame_test"
qtest "frames taken out, sequences joined, reversed and eased" "$tests/modeling_sequence_test"
qtest "one page for all frames" "$tests/frames_test"
qtest "one camera for all pictures, contact sheets, films" "$tests/sequence_picture_test"

cd "$out" && rm -f frame-*.step frame-*.svg walk.ogv
"$bin/blossom" morph star:5:20:8 circle:15 --frames 5 -o sequence.blossom >/dev/null
"$bin/blossom" extrude sequence.blossom --height 4 -o frame.step --json >extruded.json
equal "a sequence extruded: STEP files" "$(ls frame-*.step | wc -l)" 5
"$bin/blossom" morph star:5:20:8 circle:15 --frames 5 -o frame.svg >/dev/null
equal "  page of the first and of the last frame as SVG" "$(grep -o 'viewBox="[^"]*"' frame-0001.svg)" "$(grep -o 'viewBox="[^"]*"' frame-0005.svg)"
"$bin/blossom" morph star:5:20:8 circle:15 --frames 25 -o walk.ogv >/dev/null
equal "a film begins as an Ogg file" "$(head -c 4 walk.ogv)" OggS
qtest "control shapes moved, scaled and turned by handles" "$tests/minkowski_handles_test"
qtest "the same in the window, with the ladder" "$tests/minkowski_control_window_test"
