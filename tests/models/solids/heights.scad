// make.sh names the file.
file = "heights_numbers.dat";

surface(file, center = true, invert = file == "heights_inverted.png");
