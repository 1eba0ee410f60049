import { readFileSync } from "node:fs";
import glsl from "vite-plugin-glsl";

const { version } = JSON.parse(readFileSync("node_modules/vite-plugin-glsl/package.json"));

export default { base: "", plugins: [glsl()], define: { __PLUGIN_VERSION__: JSON.stringify(version) } };
