// uPlot for the type checker (tests/web/tsconfig.json): anything.
declare const uPlot: any;
export default uPlot;
