// Runs a shader through parsers and minifiers of Node.js: run.mjs SHADER FOLDER writes FOLDER/TOOL.frag for each tool. The options are
// those that docs/engines.md recommends.

import fs from "node:fs";
import path from "node:path";
import { generate, parser } from "@shaderfrog/glsl-parser/index.js";
import { preprocess } from "@shaderfrog/glsl-parser/preprocessor/index.js";
import esbuild from "esbuild";
import { glsl } from "esbuild-plugin-glsl";
import minify from "webpack-glsl-minify/build/minify.js";

const [shader, folder] = process.argv.slice(2);
const text = fs.readFileSync(shader, "utf8");

const tools = {
    "shaderfrog": () => generate(parser.parse(text, { quiet: true })),
    "shaderfrog's preprocessor": () => preprocess(text, { preserve: { version: () => true } }),
    "esbuild-plugin-glsl": async () => {
        const built = await esbuild.build({ entryPoints: [shader], write: false, format: "esm", bundle: true, plugins: [glsl({ minify: true })] });
        return (await import("data:text/javascript;base64," + Buffer.from(built.outputFiles[0].contents).toString("base64"))).default;
    },
    "webpack-glsl-minify": async () => {
        const options = { preserveDefines: true, nomangle: ["uintBitsToFloat"], output: "source" };
        return (await new minify.GlslMinify(options).execute(text)).sourceCode;
    },
};

for (const [name, tool] of Object.entries(tools)) {
    try {
        fs.writeFileSync(path.join(folder, name + ".frag"), await tool());
    } catch (error) {
        console.log(`${name}: ${String(error.message).slice(0, 300)}`);
        process.exitCode = 1;
    }
}
