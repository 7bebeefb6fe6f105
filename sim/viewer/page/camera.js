// Where the eye is.

// Of six numbers; none of others, as OpenSCAD has them.
export const cameraOf = text => {
  const numbers = text.split(',').map(Number);
  return numbers.length === 6 ? {eye: numbers.slice(0, 3), centre: numbers.slice(3)} : null;
};
