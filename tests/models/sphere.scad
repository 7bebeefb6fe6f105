// One sphere, in OpenSCAD's own facets: what a curved surface costs.
sphere(r = 10);
