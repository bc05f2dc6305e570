#!/usr/bin/env bash
# Subdivision: what is written is what was deformed, and control points stay calm
tests=$build/tests/bin
qtest "deformation: calm points, the paper's rule, lambda 0, rims, trees, cuts" "$tests/subdivision_sound_test"
at_most "  60 strokes of five clicks: farthest move / distance of the target" "$(figure subdivision_sound_test stroke_fling)" 3
at_most "  of them left over: RMS distance after / before, worst" "$(figure subdivision_sound_test stroke_left)" 0.5
at_most "  nearly planar clouds, paper's rule: farthest move / distance" "$(figure subdivision_sound_test paper_fling)" 9
at_most "  closest points: share of the places looked at" "$(figure subdivision_sound_test places_looked_at_share)" 0.02
at_most "  three semi-sharp features in 9,216 faces: limit surfaces made" "$(figure subdivision_sound_test limit_surfaces)" 40
at_most "  60 tori: faces placed per face, cuts and all" "$(figure subdivision_sound_test faces_placed_per_face)" 4
at_most "  mirrored half: its limit surface off that of the whole" "$(figure subdivision_sound_test mirrored_apart_mm)" 1e-9 mm
qtest "files: drawings in space, schemes of splines, warnings" "$tests/subdivision_files_test"
said=$(figure subdivision_files_test planar_said_mm)
at_most "  planar cage, target at z = 5: RMS in the DXF off the $said mm said" "$(awk -v a="$(figure subdivision_files_test planar_dxf_mm)" -v b="$said" 'BEGIN { print (a > b ? a - b : b - a) }')" 1e-3 mm
at_most "  the same in the STEP file" "$(awk -v a="$(figure subdivision_files_test planar_step_mm)" -v b="$said" 'BEGIN { print (a > b ? a - b : b - a) }')" 1e-3 mm
qtest "the window: a drawn outline is pulled in its plane" "$tests/subdivision_window_test"

# On the command line: what took minutes
awk -v n=224 'BEGIN { for (j = 0; j <= n; ++j) for (i = 0; i <= n; ++i) printf "v %g %g %g\n", i, j, 3 * sin(i / 9) * cos(j / 11)
  for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) { a = j * (n + 1) + i + 1; print "f", a, a + 1, a + n + 2, a + n + 1 } }' >"$out/sheet.obj"
awk 'BEGIN { for (i = 0; i < 20000; ++i) { x = 60 + 0.6 * (i % 160); y = 60 + 0.8 * int(i / 160); printf "%g %g %g\n", x, y, 3 * sin(x / 9) * cos(y / 11) + 0.2 } }' >"$out/cloud.xyz"
answer=$("$bin/blossom" deform "$out/sheet.obj" "$out/cloud.xyz" --iterations 1 -o "$out/sheet-pulled.obj" --json 2>"$out/large.log")
at_most "20,000 points on 50,176 faces, one iteration: computing" "$(awk -v t="$(json kernel_ms <<<"$answer")" 'BEGIN { print t / 1000 }')" 60 s
awk -v n=8 -v m=6 -v r=500 'BEGIN { p = atan2(0, -1) * 2; for (k = 0; k < r; ++k) { for (i = 0; i < n; ++i) for (j = 0; j < m; ++j)
    printf "v %.12g %.12g %.12g\n", 10 * (k % 25) + (3 + cos(p * j / m)) * cos(p * i / n), 10 * int(k / 25) + (3 + cos(p * j / m)) * sin(p * i / n), sin(p * j / m)
  for (i = 0; i < n; ++i) for (j = 0; j < m; ++j) { a = (i + 1) % n; b = (j + 1) % m; o = k * n * m + 1; print "f", o + i * m + j, o + a * m + j, o + a * m + b, o + i * m + b } } }' >"$out/tori.obj"
answer=$("$bin/blossom" subdivide "$out/tori.obj" -o "$out/tori.step" --json 2>>"$out/large.log")
equal "500 tori to STEP: faces" "$(json faces <<<"$answer")" 500
at_most "  computing" "$(awk -v t="$(json kernel_ms <<<"$answer")" 'BEGIN { print t / 1000 }')" 60 s
printf 'v %s\n' "0 -10 -10" "20 -10 -10" "20 10 -10" "0 10 -10" "0 -10 10" "20 -10 10" "20 10 10" "0 10 10" >"$out/half.obj"
printf 'f %s\n' "4 3 2 1" "5 6 7 8" "1 2 6 5" "2 3 7 6" "3 4 8 7" >>"$out/half.obj"
"$bin/blossom" mirror "$out/half.obj" --normal 1,0,0 --keep -o "$out/both.obj" >>"$out/large.log" 2>&1
answer=$("$bin/blossom" subdivide "$out/both.obj" --as limit -o "$out/both.stl" --json 2>>"$out/large.log")
equal "a half and its mirror image, as a limit mesh: closed" "$(json closed <<<"$answer")" true
