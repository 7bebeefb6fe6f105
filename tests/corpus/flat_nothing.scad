// What leaves nothing: a difference of all, an intersection of strangers, an empty first operand, an empty other one.
linear_extrude(20) difference() { square(5); circle(20); }
linear_extrude(20) intersection() { square(5); translate([9, 9]) square(5); }
linear_extrude(20) difference() { union() {} square(5); }
linear_extrude(20) intersection() { square(5); union() {} }
linear_extrude(6) difference() { square(8); translate([2, 2]) square(0); union() {} circle(5); }
