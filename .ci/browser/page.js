// What is wrong with the page that this is evaluated in: a list of sentences.
(() => {
    const wrong = [];
    const say = (element) => {
        const text = (element.textContent || "").trim().replace(/\s+/g, " ").slice(0, 40);
        return `<${element.localName}${element.id ? "#" + element.id : ""}> "${text}"`;
    };
    const shown = (element) => element.checkVisibility({ contentVisibilityAuto: true });
    for (const details of document.querySelectorAll("main details")) {
        details.open = true;
    }

    // Images at their natural size: loaded, and never larger than they are.
    for (const image of document.querySelectorAll("main img")) {
        if (image.closest(".img-wrapper")) continue;
        if (image.naturalWidth === 0) {
            wrong.push(`the image ${image.getAttribute("src")} is not there`);
        } else if (image.getBoundingClientRect().width > image.naturalWidth + 0.5) {
            wrong.push(`the image ${image.getAttribute("src")} is enlarged`);
        }
    }
    for (const drawing of document.querySelectorAll("figure > svg")) {
        const box = drawing.getBoundingClientRect();
        if (box.width < 50 || box.height < 20) {
            wrong.push(`the drawing ${say(drawing.parentElement)} is ${box.width} by ${box.height}`);
        }
    }

    // Formulas: laid out by MathML, in the maths font.
    const formulas = [...document.querySelectorAll("main math")].filter(shown);
    for (const formula of formulas) {
        const box = formula.getBoundingClientRect();
        const family = getComputedStyle(formula).fontFamily;
        if (box.width === 0 || box.height === 0) {
            wrong.push(`the formula ${say(formula)} has no size`);
        }
        if (!getComputedStyle(formula).display.includes("math")) {
            wrong.push(`the formula ${say(formula)} is not laid out as MathML`);
        }
        if (!family.startsWith('"New Computer Modern Math"')) {
            wrong.push(`the formula ${say(formula)} is in ${family}`);
        }
    }
    const font = [...document.fonts].find((f) => f.family.includes("New Computer Modern Math"));
    if (!font) {
        wrong.push("the page does not declare the maths font");
    } else if (formulas.length > 0 && font.status !== "loaded") {
        wrong.push(`the maths font is ${font.status}`);
    }
    if (/\$[A-Za-z\\(][^$]*\$|\{\{#/.test(document.querySelector("main").innerText.replace(/^\$ .*$/gm, ""))) {
        wrong.push("a formula or directive is left as it was written");
    }

    // No sideways scrolling of the page: what is wide scrolls within itself.
    const root = document.documentElement;
    const main = document.querySelector("main");
    const scrolls = (element) => {
        for (let e = element.parentElement; e && e !== main; e = e.parentElement) {
            if (["auto", "scroll", "hidden", "clip"].includes(getComputedStyle(e).overflowX)) {
                return true;
            }
        }
        return false;
    };
    const width = root.clientWidth;
    for (let e = main; e; e = e.parentElement) {
        if (e.scrollWidth > e.clientWidth + 1) {
            wrong.push(`<${e.localName}> scrolls sideways: ${e.scrollWidth} pixels on ${e.clientWidth}`);
        }
    }
    for (const element of document.querySelectorAll("main *")) {
        if (!shown(element) || element.closest("svg") || scrolls(element)) continue;
        const box = element.getBoundingClientRect();
        if (box.width > 0 && box.right > width + 1) {
            wrong.push(`${say(element)} reaches ${Math.round(box.right - width)} pixels beyond the screen`);
            break;
        }
    }

    // Contrast of text against what lies behind it (WCAG's relative luminance), at least 4.5.
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 1;
    const pen = canvas.getContext("2d", { willReadFrequently: true });
    const colour = (css) => {
        pen.clearRect(0, 0, 1, 1);
        pen.fillStyle = css;
        pen.fillRect(0, 0, 1, 1);
        const [r, g, b, a] = pen.getImageData(0, 0, 1, 1).data;
        return { rgb: [r, g, b], a: a / 255 };
    };
    const over = (top, below) => top.rgb.map((c, i) => c * top.a + below[i] * (1 - top.a));
    const behind = (element) => {
        const layers = [];
        for (let e = element; e; e = e.parentElement) {
            const layer = colour(getComputedStyle(e).backgroundColor);
            layers.push(layer);
            if (layer.a === 1) break;
        }
        return layers.reverse().reduce((below, layer) => over(layer, below), [255, 255, 255]);
    };
    const luminance = (rgb) => {
        const [r, g, b] = rgb.map((c) => {
            c /= 255;
            return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
        });
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const worst = new Map();
    const walker = document.createTreeWalker(document.querySelector("main"), NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
        const element = walker.currentNode.parentElement;
        if (!walker.currentNode.textContent.trim() || !shown(element)) continue;
        if (element.closest("button, svg, .hljs")) continue;
        const back = behind(element);
        const ink = over(colour(getComputedStyle(element).color), back);
        const [high, low] = [luminance(ink), luminance(back)].sort((a, b) => b - a);
        const contrast = (high + 0.05) / (low + 0.05);
        if (contrast < 4.5) {
            const key = `${element.localName}.${element.className}`;
            worst.set(key, `${say(element)} has a contrast of ${contrast.toFixed(2)}`);
        }
    }
    wrong.push(...worst.values());

    const boxes = document.querySelectorAll("section.theorem, section.hard-case, aside.remark, section.exercise, section.erratum");
    for (const box of boxes) {
        if (!box.querySelector(".box-label")?.textContent.trim()) {
            wrong.push(`the box ${say(box)} has no label`);
        }
    }
    return { wrong, formulas: formulas.length, theme: [...root.classList].join(" ") };
})()
