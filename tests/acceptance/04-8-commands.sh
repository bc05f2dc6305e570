#!/usr/bin/env bash
# The command lines that the spec prints, each of its flags and formats
tool=$(realpath "$bin/blossom")
made() { (cd "$out" && "$tool" "$@" >/dev/null 2>&1); }
runs() { # words of a command line
  (cd "$out" && "$tool" "$@" --json >command.json 2>command.err)
  equal "$1 .. ${*: -2}" "$?" 0
}
made star -o star.svg && made rectangle -o rectangle.dxf && made box -o box.step
runs morph rectangle.dxf star.svg circle:9 --blossom 0.2,0.7 --evaluation recursive --tolerance 0.02 -o morph.svg
runs morph rectangle.dxf star.svg --t 0.5 --evaluation bottom-up --degree-elevate --area-preserving -o morph.dxf
runs morph rectangle.dxf star.svg --t 0.25 --evaluation explicit -o morph.ps
runs morph rectangle.dxf circle:5 rectangle.dxf --t 0.75 --evaluation convex -o morph.pdf
runs morph rectangle.dxf star.svg --frames 3 -o frames.step
equal "  its frames, a file each" "$(find "$out" -name 'frames-000[123].step' | wc -l)" 3
runs minkowski-sum rectangle.dxf star.svg -o sum.svg
runs minkowski-difference rectangle.dxf circle:1 -o difference.dxf
for kind in off obj stl ply 3mf step; do runs solid-sum box.step ball:2:1 -o "solid.$kind"; done
runs solid-difference box.step ball:1:1 -o difference.3mf
runs solid-open box.step ball:1:1 -o open.off
runs solid-close box.step ball:1:1 -o close.off
runs solid-morph box.step ball:5:1 --t 0.5 --control ease -o between.obj
runs inflate box.step --radius 1 -o inflated.stl
runs melt box.step --radius 1 --frames 2 -o melted.ply
runs offset --text Blossom --font DejaVuSans --distance 0.2,0.4 --side both -o offset.svg
runs medial-axis --text Blossom --font DejaVuSans -o axis.dxf
runs pocket --text Blossom --font DejaVuSans --tool-diameter 0.5 --depth 1 --stepover 45% --stepdown 0.5 --post linuxcnc -o text.ngc
runs simulate text.ngc --text Blossom --font DejaVuSans
at_most "  residue" "$(json residue_mm2 <"$out/command.json")" 0 mm2
runs pocket box.step --face 5 --tool-diameter 2 --depth 1 -o face.ngc
runs simulate face.ngc --part box.step --face 5
printf 'v %s\n' '0 0 0' '10 0 0' '10 10 0' '0 10 0' '0 0 10' '10 0 10' '10 10 10' '0 10 10' >"$out/cage.obj"
printf 'f %s\n' '4 3 2 1' '5 6 7 8' '1 2 6 5' '2 3 7 6' '3 4 8 7' '4 1 5 8' >>"$out/cage.obj"
printf '%s\n' '4 4 11' '5 4 11' '5 5 11' '4 5 11' >"$out/target.xyz"
for kind in obj stl step; do runs deform cage.obj target.xyz --scheme catmull-clark --free rings:1 --lambda 0.001 --iterations 30 -o "pulled.$kind"; done
runs deform cage.obj target.xyz --free paper -o paper.obj
runs subdivide cage.obj --levels 2 -o fine.obj
