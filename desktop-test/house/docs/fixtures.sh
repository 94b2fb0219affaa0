# What the commands of the documents name: sequences under the documents' names, small ones, all rendered here in a few
# seconds. Sourced by commands.py in the tree where the commands run.
# shellcheck shell=bash
./glide synth first_walk --frames 60 --size 320x240 --quiet
./glide synth MH_01_easy --layout euroc --frames 60 --size 320x240 --quiet
# TUM's sequences come without a calibration: the preset is told by the folder's name.
./glide synth rgbd_dataset_freiburg3_long_office_household --frames 40 --quiet
rm rgbd_dataset_freiburg3_long_office_household/camera.yaml

ln -s first_walk second_walk
ln -s first_walk DIR
ln -s MH_01_easy FOLDER

cp first_walk/camera.yaml camera.yaml
mkdir images
count=0
for image in first_walk/rgb/*.png; do
  ln -s "../$image" "images/$(printf %04d "$count").png"
  count=$((count + 1))
done
ffmpeg -loglevel error -framerate 30 -i images/%04d.png -pix_fmt yuv420p walk.mp4
cat >camchain.yaml <<TEXT
cam0:
  camera_model: pinhole
  intrinsics: [262.4, 262.4, 161.1, 117.9]
  resolution: [320, 240]
  distortion_model: radtan
  distortion_coeffs: [0.0, 0.0, 0.0, 0.0]
TEXT

cp desktop-test/house/consumer/track_folder.c track.c
mkdir grey
ffmpeg -loglevel error -i images/%04d.png -frames:v 20 grey/%04d.pgm
