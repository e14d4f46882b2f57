# Rate of loss of energy over the reference: pictures/dissipation.png and .svg. Run in the folder of the case.
set datafile separator comma
set datafile commentschars '#'
set key autotitle columnhead
set xlabel 'time [s]'
set ylabel 'mean dissipation [m^2/s^3]'
set xrange [0:10]
set yrange [0:*]
set key top left
set grid
nu = 1.0/1600
system 'mkdir -p pictures'

do for [type in 'png svg'] {
    eval 'set terminal '.(type eq 'png' ? 'pngcairo' : 'svg background "white"').' size 900,600 font "sans,12"'
    set output 'pictures/dissipation.'.type
    plot 'postProcessing/dissipation.csv' using 1:3 with lines lw 2 lc rgb '#c0392b' title '-dE/dt', \
         '' using 1:(2*nu*$4) with lines lw 2 dt 2 lc rgb '#2c5f8a' title '2 nu Z', \
         'validation/dissipation.csv' using 1:3 every 2 with points pt 6 ps 0.8 lc rgb '#444444' title 'van Rees 2011, 512^3'
    unset output
}
