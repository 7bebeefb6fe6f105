icarus verilator waves:
	@echo "this design has no Program to draw; create one with csgsim rtl @MACHINE@ MODEL.csg -o FOLDER"; false
