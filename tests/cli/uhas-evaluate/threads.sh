# the same scores, but for the time, for any number of threads
for threads in 1 3; do
  uhas-evaluate profile/allegro_right.h5 --urdf hand/allegro_right.urdf --actions 25 --lines 5 --threads $threads --json |
    grep -v '"time"' > $threads.json
done
cmp 1.json 3.json && echo same
#> same
