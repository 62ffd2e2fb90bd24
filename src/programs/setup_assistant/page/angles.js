// Angles in the settings are in radians unless the file says deg(20). They are shown in degrees if it does, or if the
// user has chosen so; what is then typed is written as deg().
import {show, view} from './view_state.js';

export const DEGREES = 180 / Math.PI;

const TEXT = /^\s*deg\(\s*([-+]?[\d.]+(?:[eE][-+]?\d+)?)\s*\)\s*$/;

// The radians of a number or of a text such as deg(20); undefined for anything else.
export function radiansOf(value) {
  if (typeof value === 'number') return value;
  const degrees = TEXT.exec(String(value ?? ''))?.[1];
  return degrees === undefined ? undefined : Number(degrees) / DEGREES;
}

// Whether a value, or one in it, is written in degrees.
export function saysDegrees(value) {
  if (value !== null && typeof value === 'object') return Object.values(value).some(saysDegrees);
  return typeof value === 'string' && TEXT.test(value);
}

export function inDegrees(value) {
  return view.angles === 'deg' || saysDegrees(value);
}

// A value with its angles as numbers in the unit, as they are shown; what is not a plain angle stays as it is.
export function shownAngles(value, isInDegrees) {
  return mapped(value, (radians) => (isInDegrees ? round(radians * DEGREES, 3) : round(radians, 4)));
}

// The value as it is written to the file, from numbers in the unit.
export function writtenAngles(value, isInDegrees) {
  return isInDegrees ? mapped(value, (degrees) => inText(degrees)) : value;
}

// A value of the settings with all of its angles written in the unit.
export function convertedAngles(value, isInDegrees) {
  return mapped(value, (radians) => (isInDegrees ? inText(radians * DEGREES) : round(radians, 6)));
}

function round(value, digits) {
  return Number(value.toFixed(digits));
}

// Zero is zero in each unit.
function inText(degrees) {
  const rounded = round(degrees, 3);
  return rounded === 0 ? 0 : `deg(${rounded})`;
}

function mapped(value, change) {
  if (Array.isArray(value)) return value.map((each) => mapped(each, change));
  if (value !== null && typeof value === 'object') {
    // The weights of a choice are not angles.
    return Object.fromEntries(
        Object.entries(value).map(([key, each]) => [key, key === 'weights' ? each : mapped(each, change)]));
  }
  const number = radiansOf(value);
  return number === undefined ? value : change(number);
}

export function chooseUnit(isInDegrees) {
  show({angles: isInDegrees ? 'deg' : 'rad'});
}
