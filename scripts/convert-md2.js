// Converts the first frame of a model in Quake II's format MD2 to NAME.obj and NAME.mtl, with the texture NAME.bmp.
// Usage: node convert-md2.js MODEL NAME
const files = require("fs");
const [model, name] = process.argv.slice(2);
const data = files.readFileSync(model);
const header = (index) => data.readInt32LE(4 * index);
const [width, height] = [header(2), header(3)];
const [numPoints, numCoordinates, numTriangles] = [header(6), header(7), header(8)];
const [coordinates, triangles, frame] = [header(12), header(13), header(14)];

const lines = [`mtllib ${name}.mtl`, "usemtl skin"];
for (let point = 0; point < numPoints; ++point) {
    const place = [0, 1, 2].map((axis) => {
        const scale = data.readFloatLE(frame + 4 * axis);
        const origin = data.readFloatLE(frame + 12 + 4 * axis);
        return origin + scale * data[frame + 40 + 4 * point + axis];
    });
    lines.push(`v ${place[1]} ${place[2]} ${place[0]}`); // Z-up, facing X, to Y-up, facing Z
}
for (let index = 0; index < numCoordinates; ++index) {
    const [s, t] = [0, 2].map((offset) => data.readInt16LE(coordinates + 4 * index + offset));
    lines.push(`vt ${(s + 0.5) / width} ${1 - (t + 0.5) / height}`);
}
for (let triangle = 0; triangle < numTriangles; ++triangle) {
    const numbers = [0, 1, 2, 3, 4, 5].map((index) => 1 + data.readUInt16LE(triangles + 12 * triangle + 2 * index));
    lines.push("f " + [2, 1, 0].map((corner) => `${numbers[corner]}/${numbers[corner + 3]}`).join(" "));
}
files.writeFileSync(`${name}.obj`, lines.join("\n") + "\n");
files.writeFileSync(`${name}.mtl`, `newmtl skin\nKd 1 1 1\nmap_Kd ${name}.bmp\n`);
