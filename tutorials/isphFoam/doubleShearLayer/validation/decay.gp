# Decay of energy and enstrophy, over the reference: pictures/decay.png and .svg. Run in the folder of the case.
set datafile separator comma
set datafile commentschars '#'
set key autotitle columnhead
set xlabel 'time [s]'
set ylabel 'enstrophy Z/Z_0'
set y2label 'energy K/K_0'
set ytics nomirror
set y2tics
set yrange [0:1.05]
set y2range [0.94:1.0025]
set key bottom left
set grid
system 'mkdir -p pictures'

do for [type in 'png svg'] {
    eval 'set terminal '.(type eq 'png' ? 'pngcairo' : 'svg background "white"').' size 900,600 font "sans,12"'
    set output 'pictures/decay.'.type
    plot 'postProcessing/decay.csv' using 1:3 with lines lw 2 lc rgb '#c0392b' title 'enstrophy', \
         '' using 1:2 axes x1y2 with lines lw 2 lc rgb '#2c5f8a' title 'energy (right)', \
         'validation/decay.csv' using 1:3 with points pt 6 ps 1.4 lc rgb '#c0392b' title '256^2, exact derivatives', \
         '' using 1:2 axes x1y2 with points pt 6 ps 1.4 lc rgb '#2c5f8a' title '256^2 (right)'
    unset output
}
