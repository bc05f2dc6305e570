#!/usr/bin/env bash
# 11, 12: what stays uncut is told from the moves; pockets on faces keep clear of all of the solid
qtest "11 uncut area: closed forms, random moves against columns, slots about as wide as the tool" "$build/tests/bin/pocket_uncut_test"
uncut() { figure pocket_uncut_test "$1"; }
at_most "  slots of r(2 + e): cut by columns + uncut told, off the part" "$(uncut slots_cut_and_uncut_off)" 1e-4
at_least "  of these slots cut" "$(uncut slots_cut)" 1
at_least "  of these slots told as uncut, with place" "$(uncut slots_told_uncut)" 1
at_most "  narrow arm: told against its closed form" "$(uncut arm_uncut_off_mm2)" 0.02 mm2
qtest "11 slots and holes as wide as the tool: bent by arcs and splines, with rooms, a little wider or narrower" "$build/tests/bin/pocket_slot_test"
slots() { figure pocket_slot_test "$1"; }
at_most "  40 bent slots just as wide: cut by columns + uncut told, off the part" "$(slots bent_slots_cut_and_uncut_off)" 1e-4
at_most "  deepest cut into their walls" "$(slots bent_slots_gouge_mm)" 0.005 mm
at_most "  1e-9 to 1e-2 wider or narrower: cut + uncut, off the part" "$(slots bent_slots_about_as_wide_off)" 1e-4
qtest "12 faces of solids: boss, floor, overhang, bridge, a face that looks aside" "$build/tests/bin/pocket_solid_test"
solid() { figure pocket_solid_test "$1"; }
at_most "  boss of 25 mm: deepest that the tool goes into it" "$(solid boss_hit_mm)" 0.0051 mm
at_least "  boss of 25 mm on 20 mm: lowest rapid across" "$(solid boss_lowest_rapid_mm)" 50 mm
equal "  floor of a pocket at 5 mm: lowest cut" "$(solid floor_lowest_mm)" 5
at_least "  walls up to 20 mm: lowest rapid across" "$(solid floor_lowest_rapid_mm)" 25 mm
