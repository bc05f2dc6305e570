#!/usr/bin/env bash
# pocket programs: LinuxCNC's interpreter, gouge and residue, refusals, speed
qtest "every drawing, three tools, through rs274 and swept" "$build/tests/bin/pocket_rs274_test" BLOSSOM_SHARED_DATA="$data" QTEST_FUNCTION_TIMEOUT=3600000
swept() { figure pocket_rs274_test "$1"; }
at_least "  drawings with closed regions" "$(swept drawings_parts)" 60
at_least "  programs that rs274 ran without error" "$(swept drawings_programs)" 180
at_least "  G2 and G3 among their moves" "$(swept drawings_arcs)" 1000
at_most "  gouge over output resolution plus arc tolerance" "$(swept drawings_gouge_share)" 1
at_most "  residue where the tool reaches" "$(swept drawings_residue)" 0 mm2
at_most "  own parts: gouge over what is allowed" "$(swept own_gouge_share)" 1
at_most "  own parts: residue" "$(swept own_residue)" 0 mm2
qtest "paths: closed forms, stepovers, entries, finishing, rubbish" "$build/tests/bin/pocket_path_test"
qtest "simulation: closed forms, brute force, rubbish" "$build/tests/bin/pocket_simulate_test"
qtest "programs: every post, arcs after rounding, read back" "$build/tests/bin/gcode_program_test"

refused=$("$bin/blossom" pocket rectangle:60:8 --tool-diameter 10 --depth 2 -o "$out/refused.ngc" --json)
equal "a tool that does not fit: the largest that would" "$(json hint <<<"$refused" | grep -oE '[0-9.]+ mm')" "8 mm"
cover=$("$bin/blossom" pocket "$root/resources/samples/pocket-cover.blossom#boolean-1" --tool-diameter 6 --depth 9 --stepdown 3 --finish 0.2 -o "$out/cover.ngc" --json)
at_most "cover: gouge by its own simulation" "$(json gouge_mm <<<"$cover")" 0.0051 mm
at_most "cover: residue" "$(json residue_mm2 <<<"$cover")" 0 mm2
measured=$("$bin/blossom" simulate "$out/cover.ngc" --part "$root/resources/samples/pocket-cover.blossom#boolean-1" --json)
at_most "simulate the program as written: gouge" "$(json gouge_mm <<<"$measured")" 0.0052 mm
at_most "simulate the program as written: residue" "$(json residue_mm2 <<<"$measured")" 0 mm2
larger=$("$bin/blossom" simulate "$out/cover.ngc" --part "$root/resources/samples/pocket-cover.blossom#boolean-1" --tool-diameter 7 --json)
at_least "simulate with a tool 1 mm larger: gouge" "$(json gouge_mm <<<"$larger")" 0.49 mm
at_most "  and no more than that" "$(json gouge_mm <<<"$larger")" 0.51 mm
