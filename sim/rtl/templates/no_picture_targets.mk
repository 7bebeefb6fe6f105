icarus verilator waves:
	@echo "this design has no Program to draw: csgsim rtl @MACHINE@ MODEL.csg -o FOLDER makes one that has"; false
