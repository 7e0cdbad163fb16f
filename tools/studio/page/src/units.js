// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them: enough digits to tell two designs apart, and a unit.

/** Digits after the point for a value of a parameter. */
export const digitsOf = (unit) => (unit === "m" ? 4 : unit === "rad" ? 3 : 3);

/** @param {number} value @param {string} unit */
export function format(value, unit) {
  return Number.isFinite(value) ? `${value.toFixed(digitsOf(unit))} ${unit}`.trim() : "–";
}

/** A number of unknown size with about so many digits that count. */
export function significant(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -4 || size > 6) return value.toExponential(digits - 2).replace("e+", "e");
  return value.toFixed(Math.max(0, Math.min(6, digits - 1 - size)));
}

/** A change with its sign. */
export function signed(value, unit) {
  if (!Number.isFinite(value)) return "–";
  const text = unit === undefined ? significant(value, 3) : format(value, unit);
  return value > 0 ? `+${text}` : text.replace("-", "−");
}

/** Seconds as a clock would say them. */
export function duration(seconds) {
  if (!Number.isFinite(seconds)) return "";
  if (seconds < 60) return `${Math.max(1, Math.round(seconds))} s`;
  return `${Math.floor(seconds / 60)} min ${Math.round(seconds % 60)} s`;
}

/** "front_thigh_length" as words. */
export const words = (name) => name.replaceAll("_", " ");
