polygon([for (i = [0 : 6]) 10 * [cos(i * 3 * 360 / 7), sin(i * 3 * 360 / 7)]]);
