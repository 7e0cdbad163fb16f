// SPDX-License-Identifier: Apache-2.0
// The shapes of what the server sends and a report embeds, as JSDoc types. Lengths are in metres,
// angles in radians, forces in newtons, quaternions wxyz, frames MuJoCo's: z up.

/**
 * @typedef {object} Geom a drawable of a body
 * @property {string|number} body name or index of the body that carries it
 * @property {string} type box, sphere, capsule, cylinder, ellipsoid, mesh or plane
 * @property {number[]} size MuJoCo's half sizes
 * @property {number[]} pos in the body's frame
 * @property {number[]} quat in the body's frame
 * @property {number[]} rgba
 * @property {?number|string} mesh id of its mesh
 * @property {number} group MuJoCo's; 3 and higher are not drawn
 */
/**
 * @typedef {object} Design a body as it is drawn
 * @property {number} revision
 * @property {{name: string, parent: (string|number)}[]} bodies
 * @property {Geom[]} geoms
 * @property {Object<string, Mesh>=} meshes by id, where they are embedded
 */
/**
 * @typedef {object} Mesh base64 of little-endian arrays
 * @property {string} vertices float32
 * @property {string=} normals float32
 * @property {string} faces uint32
 */
/**
 * @typedef {object} Fault something wrong in a motion
 * @property {string} kind slip, cone, joint, torque, touch
 * @property {number} from phase of the cycle, 0 to 1
 * @property {number} to phase of the cycle
 * @property {string|number} body at which it is drawn
 * @property {number[]} at in the body's frame
 * @property {string} words
 */
/**
 * @typedef {object} Motion a planned cycle
 * @property {number} revision
 * @property {number} period [s]
 * @property {number} frames poses over the cycle; the first follows the last
 * @property {string[]|number} bodies
 * @property {number=} root the trunk's body
 * @property {string} poses base64 float32 [frames][bodies][7]: position, quaternion; world
 * @property {number[]} advance [dx, dy, dyaw] of a cycle
 * @property {{name: string, body: (string|number), stance: number[]}[]} feet
 * @property {string} forces base64 float32 [frames][feet][3]
 * @property {Fault[]} faults
 * @property {boolean} predicted to first order, not yet solved for
 */
/**
 * @typedef {object} Handle how a parameter is taken hold of on the robot
 * @property {"move"|"turn"|"scale"} kind
 * @property {string|number} body
 * @property {number[]} at in the body's frame
 * @property {number[]} direction of the position with the value; of turn: the axis
 * @property {{body: number, at: number[], direction: number[]}[]} also on other limbs
 */
/**
 * @typedef {object} Parameter
 * @property {string} name
 * @property {string} sentence
 * @property {string} unit m or rad
 * @property {number} value
 * @property {number} given the robot file's own
 * @property {number} robot_lower
 * @property {number} robot_upper
 * @property {{name: string, mirrored: boolean}[]=} tie what it changes
 * @property {string=} group
 * @property {?Handle} handle
 */

export {};
