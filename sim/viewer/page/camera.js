// Parses the camera.

// Eye and centre from six numbers; null for any other number of them, as in OpenSCAD's form with rotations.
export const cameraOf = text => {
  const numbers = text.split(',').map(Number);
  return numbers.length === 6 ? {eye: numbers.slice(0, 3), centre: numbers.slice(3)} : null;
};
