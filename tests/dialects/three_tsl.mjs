// The part of "three/tsl" that shaders/nodes/three uses, evaluated on the CPU instead of compiled. A node holds the
// values of all points, an array of 32-bit numbers for each of its components.

const ARRAYS = { float: Float32Array, int: Int32Array, uint: Uint32Array };

class Node {
    constructor(type, parts) { this.type = type; this.parts = parts; }
    toVar() { return new Node(this.type, this.parts); }
    assign(other) { this.parts = other.parts; }
    add(other) { return combined(this, other, (a, b) => a + b); }
    sub(other) { return combined(this, other, (a, b) => a - b); }
    mul(other) { return combined(this, other, this.type === "float" ? (a, b) => a * b : Math.imul); }
    div(other) { return combined(this, other, (a, b) => a / b); } // storing truncates integers
    bitXor(other) { return combined(this, other, (a, b) => a ^ b); }
    bitOr(other) { return combined(this, other, (a, b) => a | b); }
    shiftLeft(other) { return combined(this, other, (a, b) => a << b); }
    shiftRight(other) { return combined(this, other, this.type === "uint" ? (a, b) => a >>> b : (a, b) => a >> b); }
    lessThan(other) { return combined(this, other, (a, b) => a < b); }
    negate() { return mapped(this, a => -a); }
}
for (const swizzle of ["x", "y", "z", "w", "yz", "zw", "yzw", "yzx", "zxy"])
    Object.defineProperty(Node.prototype, swizzle, { get() {
        return new Node(this.type, [...swizzle].map(part => this.parts["xyzw".indexOf(part)]));
    } });

// A number applies to all components, and a single value to all points.
function combined(a, b, operation) {
    if (!(b instanceof Node))
        b = converted(a.type)(b);
    if (a.type !== b.type)
        throw new Error(`${a.type} meets ${b.type}`);
    const parts = Array.from({ length: Math.max(a.parts.length, b.parts.length) }, (_, part) => {
        const left = a.parts[part % a.parts.length], right = b.parts[part % b.parts.length];
        const result = new ARRAYS[a.type](Math.max(left.length, right.length));
        const step_left = left.length > 1 ? 1 : 0, step_right = right.length > 1 ? 1 : 0;
        for (let i = 0; i < result.length; ++i)
            result[i] = operation(left[step_left * i], right[step_right * i]);
        return result;
    });
    return new Node(a.type, parts);
}

const mapped = (node, operation) => new Node(node.type, node.parts.map(part => part.map(operation)));
const converted = type => value => new Node(type, value instanceof Node
    ? value.parts.map(part => new ARRAYS[type](part)) : [ARRAYS[type].of(value)]);
const vector = (type, size) => (...given) => {
    const parts = given.flatMap(value => converted(type)(value).parts);
    return new Node(type, Array.from({ length: size }, (_, part) => parts[part % parts.length]));
};

export const float = converted("float");
export const int = converted("int");
export const uint = converted("uint");
export const vec2 = vector("float", 2);
export const vec3 = vector("float", 3);
export const vec4 = vector("float", 4);
export const ivec2 = vector("int", 2);
export const ivec3 = vector("int", 3);
export const abs = node => mapped(node, Math.abs);
export const exp = node => mapped(node, Math.exp);
export const floor = node => mapped(node, Math.floor);
export const ceil = node => mapped(node, Math.ceil);
export const sqrt = node => mapped(node, Math.sqrt);
export const inverseSqrt = node => mapped(node, value => 1 / Math.sqrt(value));
export const pow = (node, power) => combined(node, power, Math.pow);
export const sign = node => mapped(node, Math.sign);
export const min = (node, most) => combined(node, most, Math.min);
export const max = (node, least) => combined(node, least, Math.max);
export const clamp = (node, least, most) => min(max(node, least), most);
export const dot = (a, b) => a.mul(b).parts.map(part => new Node("float", [part])).reduce((sum, part) => sum.add(part));
export const length = node => mapped(dot(node, node), Math.sqrt);
export const normalize = node => node.div(length(node));
export const select = (condition, yes, no) => new Node(yes.type,
    [yes.parts[0].map((value, i) => condition.parts[0][i] ? value : no.parts[0][i])]);
export const Fn = body => {
    const call = (...given) => body(given);
    call.setLayout = () => call;
    return call;
};
export const cross = (a, b) => vec3(...[0, 1, 2].map(i => {
    const [j, k] = [(i + 1) % 3, (i + 2) % 3], part = (node, index) => new Node("float", [node.parts[index]]);
    return part(a, j).mul(part(b, k)).sub(part(a, k).mul(part(b, j)));
}));
// Rows of 256 points, seen from the front, of a surface whose y points up and the pixels' down, as in WebGPU.
const stepped = step => node => mapped(node, (value, i, part) => part.length === 1 ? 0
    : Math.floor(i / step) % 2 ? value - part[i - step] : part[i + step] - value);
export const dFdx = stepped(1), dFdy = stepped(256);
const points = Float32Array.from({ length: 256 * 32 }, (_, i) => i);
const along = place => mapped(new Node("float", [points]), place);
export const positionView = vec3(along(i => (i % 256 + 0.5) / 64), along(i => -(Math.floor(i / 256) + 0.5) / 64), 0);
export const normalView = vec3(0, 0, 1);
export const Loop = (count, body) => { // the same for all points
    for (let i = 0; i < count.parts[0][0]; ++i)
        body({ i: int(i) });
};
