icarus: icarus.png
icarus.vvp: testbench.v $(DESIGN) $(wildcard rtl/*.vh)
	iverilog -g2005 -Wall -Irtl -s testbench -o $@ testbench.v $(DESIGN)
icarus.ppm: icarus.vvp $(MEMORIES)
	vvp -n icarus.vvp +picture=$@ +frames=$(FRAMES)

verilator: verilator.png
verilated/testbench: testbench.v $(DESIGN) $(wildcard rtl/*.vh)
	verilator --binary -O3 -Wall --top-module testbench -Irtl --Mdir verilated -o testbench \
	  -MAKEFLAGS "OPT_FAST=$(OPTIMISE) OPT_SLOW=-O0" testbench.v $(DESIGN) >verilated.log
verilator.ppm: verilated/testbench $(MEMORIES)
	verilated/testbench +picture=$@ +frames=$(FRAMES)

waves: icarus.vvp
	vvp -n icarus.vvp +picture=icarus.ppm +frames=1 +wave=wires.vcd
	@echo "wires.vcd: gtkwave wires.vcd"

beside: icarus.vvp
	python3 beside.py $(WAVE)

%.png: %.ppm
	python3 png.py $< $@
