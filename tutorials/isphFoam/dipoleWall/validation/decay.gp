# Decay of energy and enstrophy over a reference, where there is one: pictures/decay.png and .svg. Run in the folder of the
# case, with reference set to the file.
set datafile separator comma
set datafile commentschars '#'
set xlabel 'time [s]'
set ylabel 'enstrophy Z [m^2/s^2]'
set y2label 'energy E [m^4/s^2]'
set ytics nomirror
set y2tics
set yrange [0:*]
set y2range [0:*]
set key top right
set grid
set style data lines
system 'mkdir -p pictures'
known = system('[ -f "'.reference.'" ] && echo 1 || echo 0') + 0
file = 'postProcessing/decay.csv'

do for [type in 'png svg'] {
    eval 'set terminal '.(type eq 'png' ? 'pngcairo' : 'svg background "white"').' size 900,600 font "sans,12"'
    set output 'pictures/decay.'.type
    plot file using 1:3 skip 1 lw 2 lc rgb '#c0392b' title 'enstrophy', \
         '' using 1:4 skip 1 lw 1 dt 2 lc rgb '#c0392b' title 'enstrophy, from the energy budget', \
         '' using 1:2 skip 1 axes x1y2 lw 2 lc rgb '#2c5f8a' title 'energy (right)', \
         (known ? reference : file) using 1:(known ? $3 : NaN) skip 1 every 2 with points pt 6 ps 0.8 lc rgb '#c0392b' \
             title (known ? 'reference' : ''), \
         '' using 1:(known ? $2 : NaN) skip 1 every 2 axes x1y2 with points pt 6 ps 0.8 lc rgb '#2c5f8a' title (known ? 'reference (right)' : '')
    unset output
}
