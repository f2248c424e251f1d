// Converts a model in glTF 1.0, in its first pose, to NAME.obj and NAME.mtl; every texture becomes NAME.png.
// Usage: node convert-gltf.js MODEL NAME
const files = require("fs");
const path = require("path");
const [model, name] = process.argv.slice(2);
const gltf = JSON.parse(files.readFileSync(model, "utf8"));
const buffers = {};
for (const [id, buffer] of Object.entries(gltf.buffers))
    buffers[id] = files.readFileSync(path.join(path.dirname(model), buffer.uri));

function readAccessor(id) {
    const accessor = gltf.accessors[id];
    const view = gltf.bufferViews[accessor.bufferView];
    const data = buffers[view.buffer];
    const components = { SCALAR: 1, VEC2: 2, VEC3: 3 }[accessor.type];
    const isFloat = accessor.componentType === 5126;
    const stride = accessor.byteStride || components * (isFloat ? 4 : 2);
    const begin = view.byteOffset + accessor.byteOffset;
    return Array.from({ length: accessor.count }, (_, element) =>
        Array.from({ length: components }, (_, component) => {
            const place = begin + element * stride + component * (isFloat ? 4 : 2);
            return isFloat ? data.readFloatLE(place) : data.readUInt16LE(place);
        }));
}

// Rotate a vector by a quaternion.
function rotate([x, y, z, w], vector) {
    const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    const twice = cross([x, y, z], vector).map((value) => 2 * value);
    const last = cross([x, y, z], twice);
    return vector.map((value, axis) => value + w * twice[axis] + last[axis]);
}

function toParent(node, point) {
    if (node.matrix)
        return [0, 1, 2].map((row) =>
            node.matrix[12 + row] + point.reduce((sum, value, column) => sum + value * node.matrix[4 * column + row], 0));
    return rotate(node.rotation, point.map((value, axis) => value * node.scale[axis]))
        .map((value, axis) => value + node.translation[axis]);
}

const lines = [`mtllib ${name}.mtl`];
let numPoints = 0;
function writeNode(id, outer) {
    const node = gltf.nodes[id];
    const toScene = (point) => outer(toParent(node, point));
    for (const mesh of node.meshes || [])
        for (const primitive of gltf.meshes[mesh].primitives) {
            const points = readAccessor(primitive.attributes.POSITION);
            for (const point of points) lines.push(`v ${toScene(point).join(" ")}`);
            for (const [s, t] of readAccessor(primitive.attributes.TEXCOORD_0)) lines.push(`vt ${s} ${1 - t}`);
            lines.push(`usemtl ${primitive.material}`);
            const corners = readAccessor(primitive.indices).map(([index]) => 1 + numPoints + index);
            for (let first = 0; first < corners.length; first += 3)
                lines.push("f " + corners.slice(first, first + 3).map((corner) => `${corner}/${corner}`).join(" "));
            numPoints += points.length;
        }
    for (const child of node.children || []) writeNode(child, toScene);
}
for (const id of gltf.scenes[gltf.scene].nodes) writeNode(id, (point) => point);
files.writeFileSync(`${name}.obj`, lines.join("\n") + "\n");

const materials = Object.entries(gltf.materials).map(([id, material]) => {
    const diffuse = material.values.diffuse;
    const isTexture = typeof diffuse === "string";
    return `newmtl ${id}\nKd ${isTexture ? "1 1 1" : diffuse.slice(0, 3).join(" ")}\n` +
        (isTexture ? `map_Kd ${name}.png\n` : "");
});
files.writeFileSync(`${name}.mtl`, materials.join(""));
